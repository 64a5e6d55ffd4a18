//! The keywords, one file each.

/// The page of a keyword, the same text that stands in the documentation.
macro_rules! page {
    ($file:literal) => {
        include_str!(concat!("../../../../docs/keywords/", $file, ".md"))
    };
}

pub(crate) mod allowable;
pub(crate) mod amplitude;
pub(crate) mod assembly;
pub(crate) mod beam_section;
pub(crate) mod boundary;
pub(crate) mod cload;
pub(crate) mod contact_controls;
pub(crate) mod contact_file;
pub(crate) mod contact_output;
pub(crate) mod contact_pair;
pub(crate) mod contact_print;
pub(crate) mod controls;
pub(crate) mod el_file;
pub(crate) mod el_print;
pub(crate) mod elastic;
pub(crate) mod element;
pub(crate) mod element_output;
pub(crate) mod elgen;
pub(crate) mod elset;
pub(crate) mod end_assembly;
pub(crate) mod end_instance;
pub(crate) mod end_part;
pub(crate) mod end_step;
pub(crate) mod friction;
pub(crate) mod heading;
pub(crate) mod hyperelastic;
pub(crate) mod instance;
pub(crate) mod interface;
pub(crate) mod material;
pub(crate) mod mpc;
pub(crate) mod ngen;
pub(crate) mod nmap;
pub(crate) mod node;
pub(crate) mod node_file;
pub(crate) mod node_output;
pub(crate) mod node_print;
pub(crate) mod nset;
pub(crate) mod output;
pub(crate) mod part;
pub(crate) mod plastic;
pub(crate) mod print;
pub(crate) mod restart;
pub(crate) mod rigid_body;
pub(crate) mod rigid_surface;
pub(crate) mod slide_line;
pub(crate) mod solid_section;
pub(crate) mod spring;
pub(crate) mod static_;
pub(crate) mod step;
pub(crate) mod surface;
pub(crate) mod surface_behavior;
pub(crate) mod surface_contact;
pub(crate) mod surface_interaction;
pub(crate) mod transverse_shear;
