//! `slideline dakota`: one evaluation that Dakota asks for by a file.

use crate::exit::Exit;
use crate::render;
use clap::{Args, ValueHint};
use slideline::diag::{Code, Diagnostic, Sources};
use slideline::output::write_file;
use slideline_sweep::{Asked, Evaluator, Failure, prepared, read_asked, read_study};
use std::path::PathBuf;

/// `slideline dakota`.
#[derive(Args, Debug)]
pub(crate) struct DakotaArguments {
    /// What Dakota asks for, in its standard format or with aprepro.
    #[arg(value_name = "PARAMS", value_hint = ValueHint::FilePath)]
    parameters: PathBuf,
    /// Where the answer goes.
    #[arg(value_name = "RESULTS", value_hint = ValueHint::FilePath)]
    results: PathBuf,
    /// The study whose deck, parameters and responses count [default: Dakota's first analysis
    /// component].
    #[arg(long, value_name = "STUDY.toml", value_hint = ValueHint::FilePath)]
    study: Option<PathBuf>,
}

/// Evaluates one point.
pub(crate) fn dakota(arguments: &DakotaArguments) -> Exit {
    let mut sources = Sources::default();
    let found = read_asked(&arguments.parameters, &mut sources)
        .map_err(|said| vec![*said])
        .and_then(|asked| answer(arguments, &asked, &mut sources));
    let text = match found {
        Ok(text) => text,
        Err(said) => {
            render::to_standard_error(&said, &sources);
            return Exit::Input;
        }
    };
    match write_file(&arguments.results, text.as_bytes()) {
        Ok(()) => Exit::Completed,
        Err(reason) => {
            let message = format!("results could not be written: {reason}");
            let said = Diagnostic::error(Code("SL0702"), message);
            render::to_standard_error([&said.help("Free disk space.")], &sources);
            Exit::Output
        }
    }
}

fn answer(
    arguments: &DakotaArguments,
    asked: &Asked,
    sources: &mut Sources,
) -> Result<String, Vec<Diagnostic>> {
    let path = arguments.study.as_ref().or(asked.study.as_ref()).ok_or_else(|| {
        let message = "no study says which deck and which responses count";
        let help = "Write `analysis_drivers 'slideline dakota --study STUDY.toml'`, or name the \
                    study as `analysis_components`.";
        vec![Diagnostic::error(Code("SL0820"), message).help(help)]
    })?;
    let study = read_study(path, sources)?;
    let point = asked.point(&study).map_err(|said| vec![*said])?;
    let (deck, _) = prepared(&study, sources).map_err(|failure| match failure {
        Failure::Input(said) => said,
        Failure::Output(said) => vec![*said],
    })?;
    let evaluator = Evaluator::of(study.study.clone(), deck);
    let rows = match asked.wants_gradients() {
        true => evaluator.differentiate(&[point], 1, &|| false),
        false => evaluator.evaluate(&[point], 1, &|| false),
    };
    // nobody stops it: there is a row
    Ok(rows.first().map_or_else(|| "FAIL\n".to_owned(), |row| asked.answer(&study, row)))
}
