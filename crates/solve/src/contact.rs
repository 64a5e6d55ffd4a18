//! Contact pairs at work: where every slave point stands against its master.
//!
//! ```text
//!   slave point --search--> facing piece --gap--> h, sigma, derivatives
//!        |                        |                     |
//!     of a node               of nodes           pushed to dofs
//! ```
//!
//! Geometry only; pressures and tractions come from the laws, in
//! [`crate::linearised`] and [`crate::evaluate`].

mod areas;
mod before;
mod behind;
mod between;
mod beyond;
mod candidates;
mod chains;
mod cliques;
mod coverage;
mod crossing;
mod edge_crossings;
mod edge_points;
mod edges;
mod face_depth;
mod faces;
mod facing;
mod falls;
mod held_edges;
mod idle;
mod interference;
mod kinematics;
mod laws;
mod left_out;
mod master;
mod master_inside;
mod mirrors;
mod mortar;
mod mortar_faces;
mod moving;
mod near_line;
mod operator;
mod outlook;
mod pairs;
mod parts;
mod placing;
mod positions;
mod prepare;
mod presence;
mod profiles;
mod reflected;
mod search;
mod segment;
mod shear;
mod slave_face;
mod slip;
mod solids_of_side;
mod stand;
mod stencil;
mod strayed;
mod tangent;
mod thicknesses;
mod unseen;
mod values;
mod within;

pub use before::Before;
pub use candidates::{Candidates, NearContact, Reached, coupled_parts};
pub use cliques::Cliques;
pub use crossing::{Missed, Sweep, SweepScratch};
pub use edges::{EdgeInside, Found};
pub use falls::{FallsRoom, MissedAt};
pub use idle::Look;
pub use kinematics::{ContactKinematics, GeometryScratch, PointKinematics, PointRows};
pub use laws::mean_length;
pub use moving::MovingPoints;
pub use operator::{ContactOperator, OperatorRows};
pub use pairs::{Contact, SlavePoint, contact_sizes, point_count};
pub use positions::MasterPositions;
pub use profiles::placed;
pub use segment::{SEGMENT_POINTS, SlaveSegment};
