//! The words of a deck, for remedies that its author can use as they stand.
//!
//! ```text
//!   by elements (1995)             by surfaces (modern)
//!   *INTERFACE                     *SURFACE INTERACTION
//!   *SURFACE CONTACT, SOFTENED     *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL
//!   *SLIDE LINE                    *SURFACE, master of *CONTACT PAIR
//!   *RIGID SURFACE                 *SURFACE, TYPE=SEGMENTS
//! ```

/// How a deck writes a contact; every remedy takes its card names from here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Vocabulary {
    /// Contact elements with `*INTERFACE`, `*SLIDE LINE`, `*RIGID SURFACE`.
    #[default]
    Elements,
    /// `*CONTACT PAIR` of `*SURFACE`s.
    Surfaces,
    /// The same, of faces of solids.
    Faces,
}

impl Vocabulary {
    fn either(self, elements: &'static str, surfaces: &'static str) -> &'static str {
        match self {
            Self::Elements => elements,
            Self::Surfaces | Self::Faces => surfaces,
        }
    }

    /// The card with the width, to which the laws belong.
    pub fn interaction(self) -> &'static str {
        self.either("*INTERFACE", "*SURFACE INTERACTION")
    }

    /// The keyword line of an exponential pressure law.
    pub fn softened(self) -> &'static str {
        self.either(
            "*SURFACE CONTACT, SOFTENED",
            "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL",
        )
    }

    /// The whole card of that law: clearance c0 [L], pressure p0 [F/L2].
    pub fn softened_card(self, clearance: f64, pressure: f64) -> String {
        format!("{}\n{clearance:.3E}, {pressure:.3E}\n", self.softened())
    }

    /// The card that lists an analytical surface.
    pub fn rigid_surface(self) -> &'static str {
        self.either("*RIGID SURFACE", "*SURFACE, TYPE=SEGMENTS")
    }

    /// What a deforming master in the plane is called.
    pub fn chain(self) -> &'static str {
        self.either("slide line", "master")
    }

    /// How a deforming master is turned over.
    pub fn turn_chain(self) -> &'static str {
        self.either(
            "list the nodes of *SLIDE LINE in the opposite order",
            "name the other face of the master on *SURFACE (SPOS or SNEG)",
        )
    }

    /// How a deforming master is made longer.
    pub fn lengthen_chain(self) -> &'static str {
        self.either("add nodes to *SLIDE LINE", "add elements to the *SURFACE of the master")
    }

    /// How a deforming master that is in disorder is mended.
    pub fn order_chain(self) -> &'static str {
        self.either(
            "list the nodes of *SLIDE LINE in order along the part",
            "check the nodes of the elements of the master's *SURFACE",
        )
    }

    /// How the curved side gets the slaves.
    pub fn swap_roles(self) -> &'static str {
        if self == Self::Faces {
            return "name the round body, or that with the finer mesh, first on *CONTACT PAIR";
        }
        self.either(
            "put the slaves on the curved body (ISL21) and make the beam the *SLIDE LINE",
            "name the curved body first on *CONTACT PAIR, as a *SURFACE, TYPE=NODE of a *RIGID \
             BODY, TIE NSET=",
        )
    }

    /// How contact is spread over several nodes: along beams by integration, on solids by a soft
    /// law.
    pub fn integrate(self) -> &'static str {
        if self == Self::Faces {
            return "spread the force over several nodes with a softer law (*SURFACE BEHAVIOR, \
                    PRESSURE-OVERCLOSURE=EXPONENTIAL)";
        }
        self.either(
            "integrate contact along the beam: write surfaces and *CONTACT PAIR, TYPE=SURFACE TO \
             SURFACE in place of the contact elements",
            "integrate contact along the beam: *CONTACT PAIR, TYPE=SURFACE TO SURFACE",
        )
    }
}
