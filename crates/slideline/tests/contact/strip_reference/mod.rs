//! The paper's first problem, exactly: a beam that a circle touches at its face.

/// Force that pushes the circle down at the ends of the increments [N]: Reissner beam (shear factor
/// 5/6, nu = 0) that is touched at half its thickness; friction has a moment about the mid-line.
/// Source: `benches/calculix/reference.py`, which shares nothing with the solver.
pub const BEAM: [f64; 20] = [
    0.00645081350,
    0.0142158239,
    0.0245881272,
    0.0384166916,
    0.0568555622,
    0.0814887684,
    0.114514000,
    0.159016872,
    0.219387419,
    0.301964454,
    0.416053259,
    0.575570416,
    0.801772006,
    1.12791343,
    1.60747959,
    2.32929383,
    3.44653480,
    5.23552896,
    8.22279620,
    13.4823563,
];
/// The same with mu = 0.3.
pub const BEAM_WITH_FRICTION: [f64; 20] = [
    0.0479417985,
    0.101089786,
    0.167209062,
    0.249685172,
    0.352937097,
    0.482790340,
    0.647008823,
    0.856064882,
    1.12427280,
    1.47148873,
    1.92571294,
    2.52716587,
    3.33483972,
    4.43734097,
    5.97144425,
    8.15508960,
    11.3487732,
    16.1760352,
    23.7756983,
    36.3737035,
];
