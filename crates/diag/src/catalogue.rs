//! Every code with its title; the page of each stands in `docs/errors/`.

use crate::Code;

/// A code and what it is about, in a few words.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The code.
    pub code: Code,
    /// Its title.
    pub title: &'static str,
}

/// Looks a code up, letter case ignored.
pub fn entry(code: &str) -> Option<&'static Entry> {
    CATALOGUE.iter().find(|entry| entry.code.0.eq_ignore_ascii_case(code))
}

macro_rules! catalogue {
    ($($code:literal $title:literal)*) => {
        /// All codes, in ascending order.
        pub const CATALOGUE: &[Entry] = &[$(Entry { code: Code($code), title: $title }),*];
    };
}

catalogue! {
    "SL0101" "the deck is empty"
    "SL0102" "data before the first keyword"
    "SL0103" "a quotation is not closed"
    "SL0104" "a star without a keyword"
    "SL0105" "a parameter without its value"
    "SL0106" "a parameter given twice"
    "SL0107" "an empty parameter"
    "SL0108" "a comma that promises a continuation"
    "SL0109" "bytes that are not UTF-8"
    "SL0110" "a control character"
    "SL0111" "a carriage return without a line feed"
    "SL0112" "a line that is too long"
    "SL0113" "too many values on one line"
    "SL0114" "the deck is too large"
    "SL0115" "too many problems to list"
    "SL0116" "not a number"
    "SL0117" "not a whole number"
    "SL0118" "a number that is too large"
    "SL0119" "a missing value"
    "SL0120" "an included file cannot be read"
    "SL0121" "a file includes itself"
    "SL0122" "includes nested too deeply"
    "SL0123" "an include without a file name"
    "SL0201" "an unknown keyword"
    "SL0202" "an unknown parameter"
    "SL0203" "an ambiguous abbreviation"
    "SL0204" "an abbreviation was read"
    "SL0205" "a required parameter is missing"
    "SL0206" "a parameter with too little or too much"
    "SL0207" "an unknown value of a parameter"
    "SL0208" "missing data lines"
    "SL0209" "more data than the keyword takes"
    "SL0210" "a value outside its range"
    "SL0211" "a keyword hidden by a second star"
    "SL0212" "prose among the data"
    "SL0213" "a contact law without an interface"
    "SL0214" "a card in the wrong part of the deck"
    "SL0215" "parameters that exclude one another"
    "SL0216" "a negative coefficient of friction"
    "SL0217" "a very large coefficient of friction"
    "SL0218" "numbers of a pressure law"
    "SL0219" "OPT is read as OP"
    "SL0220" "an unsupported element type"
    "SL0221" "not supported"
    "SL0222" "a node defined again, unchanged"
    "SL0223" "a node defined at two places"
    "SL0224" "a number that no node or element can have"
    "SL0225" "an end of generated nodes is not defined"
    "SL0226" "an increment that does not lead to the end"
    "SL0227" "too much to generate"
    "SL0228" "a third coordinate in a plane model"
    "SL0229" "an element defined twice"
    "SL0230" "the element to repeat is not defined"
    "SL0231" "a wrong number of nodes"
    "SL0232" "a system of coordinates without direction"
    "SL0233" "a section much higher than wide"
    "SL0234" "an elastic constant outside its range"
    "SL0235" "the section keeps its size"
    "SL0236" "a card without the card it belongs to"
    "SL0237" "the shape of a rigid surface"
    "SL0238" "smoothing or extension outside its range"
    "SL0239" "a slide line with sharp corners"
    "SL0240" "a node twice in a slide line"
    "SL0241" "a stray number in a slide line"
    "SL0242" "a card given twice"
    "SL0245" "data after the end of a step"
    "SL0246" "time increments that contradict one another"
    "SL0247" "a step without NLGEOM"
    "SL0248" "a degree of freedom that does not exist"
    "SL0249" "amplitude times that do not ascend"
    "SL0250" "a name defined twice"
    "SL0251" "a degree of freedom the plane does not have"
    "SL0252" "an unknown output variable"
    "SL0253" "read, but without effect"
    "SL0254" "the areas of a node surface"
    "SL0255" "an out-of-plane thickness by default"
    "SL0256" "a face that a beam does not have"
    "SL0301" "a deck without a step"
    "SL0302" "a step that is not closed"
    "SL0303" "an element on an undefined node"
    "SL0304" "an undefined node or node set"
    "SL0305" "an empty set"
    "SL0306" "an element without length"
    "SL0307" "an element without section"
    "SL0308" "an undefined material, element or element set"
    "SL0309" "a material without elasticity"
    "SL0310" "a contact element without a surface"
    "SL0311" "a surface without contact elements"
    "SL0312" "a contact without an interface"
    "SL0313" "an interface without a surface"
    "SL0314" "a contact element claimed twice"
    "SL0315" "a dependent node is prescribed"
    "SL0316" "a node dependent twice"
    "SL0317" "a rigid link without a proper master"
    "SL0318" "contact elements of two rigid bodies"
    "SL0319" "a node is slave and master"
    "SL0320" "an element with two sections"
    "SL0321" "an undefined amplitude"
    "SL0324" "a slide line without length"
    "SL0325" "a section on elements that take none"
    "SL0326" "a friction law that nobody registered"
    "SL0327" "an undefined surface"
    "SL0328" "an undefined surface interaction"
    "SL0329" "a surface that is no open chain"
    "SL0330" "the side of a surface was chosen"
    "SL0331" "the side of a surface cannot be told"
    "SL0332" "a surface that cannot take this part"
    "SL0333" "an analytical surface without a rigid body"
    "SL0334" "a surface of two rigid bodies"
    "SL0335" "contact is integrated along the beam"
    "SL0336" "the thickness of a beam is not counted"
    "SL0337" "the slaves lie behind their master"
    "SL0338" "an interaction that nothing uses"
    "SL0345" "a middle node far from the middle"
    "SL0400" "a contact pair as it was understood"
    "SL0401" "hard contact that is integrated"
    "SL0402" "slave points overlap their master at the start"
    "SL0403" "coarse slaves on a rigid circle"
    "SL0404" "hard contact against rigid links"
    "SL0405" "increments longer than a segment"
    "SL0406" "friction that would be dropped"
    "SL0407" "a master that looks the wrong way"
    "SL0408" "a slide line too short for the stroke"
    "SL0409" "a body that nothing holds"
    "SL0410" "two nodes at one place that nothing joins"
    "SL0411" "two beams on one another"
    "SL0412" "beams that are none, or a mesh that jumps"
    "SL0413" "units that do not agree"
    "SL0414" "a body that only open contact will hold"
    "SL0501" "no equilibrium was found"
    "SL0502" "the increments are used up"
    "SL0503" "nothing holds the model"
    "SL0504" "a point slid off the end of its master"
    "SL0505" "a user friction law gave no answer"
    "SL0506" "the contact jams"
    "SL0511" "the structure snaps through"
    "SL0512" "a fixed increment is too large"
    "SL0513" "contact that chatters"
    "SL0590" "the run was interrupted"
    "SL0601" "friction was not called at closed points"
    "SL0610" "a noisy reaction"
    "SL0611" "contact that moves from node to node"
    "SL0612" "penetration beyond the pressure law"
    "SL0701" "the deck cannot be read"
    "SL0702" "results cannot be written"
    "SL0703" "the deck includes a file that is a result of the same job"
    "SL0704" "results cannot be read"
    "SL0705" "the job is still running"
    "SL0706" "the deck was changed after the run"
    "SL0901" "internal error"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_ascend_and_are_never_used_twice() {
        assert!(CATALOGUE.windows(2).all(|pair| pair[0].code < pair[1].code));
    }
}
