//! `JOB.lck`: held while a job runs.
//!
//! The file is locked, not only there: the system lets go of the lock when a
//! process ends, however it ends, so that one left by a kill stops nobody. On
//! a file system without locks nothing is held, and nothing is stopped.

use crate::file::open;
use crate::job::{JobFiles, LOCK};
use std::fs::{File, TryLockError};
use std::path::PathBuf;

/// Held by a process that writes a job's files.
#[derive(Debug)]
pub(crate) struct Lock {
    path: PathBuf,
    /// The lock is let go of with it.
    _file: File,
}

impl Lock {
    /// Takes it, if it can be had.
    pub fn take(job: &JobFiles) -> Option<Self> {
        let path = job.path(LOCK);
        let file = File::create(&path).ok()?;
        match file.try_lock() {
            Ok(()) => Some(Self { path, _file: file }),
            Err(TryLockError::WouldBlock) => None,
            Err(TryLockError::Error(_)) => {
                let _ = std::fs::remove_file(&path); // it would say nothing
                None
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.path); // one that stays is not locked
    }
}

/// Whether a process runs the job now.
pub fn is_running(job: &JobFiles) -> bool {
    let Ok(file) = open(&job.path(LOCK)) else { return false };
    matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock))
}

/// Removes what a process left that was killed while it held the lock.
pub fn remove_stale_lock(job: &JobFiles) {
    drop(Lock::take(job)); // whoever holds it keeps it
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a job is told to run while its lock is held, and at no
    /// other time; a file that a killed process left stops nobody.
    #[test]
    fn a_lock_says_that_a_job_runs() {
        let folder = std::env::temp_dir().join(format!("slideline-lock-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let job = JobFiles::new(&folder, "job");
        assert!(!is_running(&job));
        let lock = Lock::take(&job).unwrap();
        assert!(is_running(&job) && Lock::take(&job).is_none());
        drop(lock);
        assert!(!is_running(&job) && !job.path(LOCK).exists());
        std::fs::write(job.path(LOCK), "").unwrap();
        assert!(!is_running(&job) && Lock::take(&job).is_some());
        std::fs::write(job.path(LOCK), "").unwrap();
        remove_stale_lock(&job);
        assert!(!job.path(LOCK).exists());
        let lock = Lock::take(&job).unwrap();
        remove_stale_lock(&job);
        assert!(is_running(&job));
        drop(lock);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
