//! The linear theory against the tables of verification sections 1.2 and 2.

use slideline_theory::{FirstProblem, Reference, SecondProblem};

/// (k, RF2 at mu = 0, RF2 at mu = 0.3, xi_L mm, u mm, F).
const FIRST: [[f64; 6]; 21] = [
    [0.0, -0.0006635159, -0.005112117, 44.64211, -0.009073, 0.01484351],
    [1.0, -0.006455703, -0.04759535, 43.12266, -0.075637, 0.1372840],
    [2.0, -0.01422793, -0.1003248, 41.60169, -0.142144, 0.2873419],
    [3.0, -0.02461188, -0.1658843, 40.07904, -0.208582, 0.4715509],
    [4.0, -0.03845912, -0.2476152, 38.55451, -0.274936, 0.6982469],
    [5.0, -0.05692791, -0.3498768, 37.02787, -0.341186, 0.9781543],
    [6.0, -0.08160911, -0.4784145, 35.49886, -0.407307, 1.325200],
    [7.0, -0.1147116, -0.6408834, 33.96715, -0.473269, 1.757653],
    [8.0, -0.1593395, -0.8476073, 32.43239, -0.539032, 2.299752],
    [9.0, -0.2199141, -1.112695, 30.89411, -0.604548, 2.984052],
    [10.0, -0.3028276, -1.455720, 29.35178, -0.669749, 3.854888],
    [11.0, -0.4174779, -1.904284, 27.80476, -0.734553, 4.973572],
    [12.0, -0.5779465, -2.498048, 26.25223, -0.798844, 6.426379],
    [13.0, -0.8057903, -3.295215, 24.69321, -0.862473, 8.337115],
    [14.0, -1.134828, -4.383280, 23.12643, -0.925231, 10.88748],
    [15.0, -1.619636, -5.897465, 21.55030, -0.986832, 14.35112],
    [16.0, -2.351237, -8.053629, 19.96275, -1.046866, 19.15284],
    [17.0, -3.487451, -11.20974, 18.36102, -1.104745, 25.97612],
    [18.0, -5.314946, -15.98721, 16.74141, -1.159585, 35.96906],
    [19.0, -8.384926, -23.52693, 15.09879, -1.210033, 51.16510],
    [20.0, -13.83554, -36.07584, 13.42578, -1.253919, 75.41433],
];

/// (k, RM3 at mu = 0, RM3 at mu = 0.3, xi_L mm, u mm, F).
const SECOND: [[f64; 6]; 19] = [
    [2.0, -0.005373826, -0.01025052, 35.48171, -0.289701, 0.9439281],
    [3.0, -0.01041159, -0.02057968, 34.93054, -0.568988, 1.943076],
    [4.0, -0.01478853, -0.03042551, 34.37141, -0.823667, 2.952313],
    [5.0, -0.01843188, -0.03968670, 33.80603, -1.053266, 3.967876],
    [6.0, -0.02126694, -0.04825070, 33.23616, -1.257382, 4.984685],
    [7.0, -0.02321943, -0.05599457, 32.66359, -1.435688, 5.996134],
    [8.0, -0.02421867, -0.06278646, 32.09018, -1.587927, 6.993859],
    [9.0, -0.02420168, -0.06848826, 31.51782, -1.713909, 7.967497],
    [10.0, -0.02311864, -0.07295934, 30.94845, -1.813511, 8.904438],
    [11.0, -0.02093948, -0.07606189, 30.38403, -1.886675, 9.789571],
    [12.0, -0.01766204, -0.07766804, 29.82659, -1.933397, 10.60506],
    [13.0, -0.01332162, -0.07766896, 29.27815, -1.953728, 11.33016],
    [14.0, -0.008001943, -0.07598616, 28.74080, -1.947764, 11.94105],
    [15.0, -0.001847170, -0.07258496, 28.21664, -1.915640, 12.41083],
    [16.0, 0.004925440, -0.06749003, 27.70778, -1.857518, 12.70957],
    [17.0, 0.01201313, -0.06080240, 27.21634, -1.773581, 12.80456],
    [18.0, 0.01901661, -0.05271727, 26.74446, -1.664015, 12.66073],
    [19.0, 0.02543200, -0.04354105, 26.29423, -1.529005, 12.24138],
    [20.0, 0.03064761, -0.03370601, 25.86773, -1.368713, 11.50908],
];

/// Agreement to half a unit (and a little) of the seventh significant digit.
fn seven_digits(value: f64, table: f64) -> bool {
    let unit = 10f64.powf(table.abs().log10().floor() - 6.0);
    (value - table).abs() <= 0.51 * unit
}

/// Requirement: every row of the table, to all digits shown.
#[test]
fn first_problem_table() {
    let problem = FirstProblem::diehl();
    let free = problem.rows(0.0, 20, Reference::Linear).unwrap();
    let rubbing = problem.rows(0.3, 20, Reference::Linear).unwrap();
    for (k, table) in FIRST.iter().enumerate() {
        let (row, rub) = (free[k], rubbing[k]);
        assert_eq!(row.increment as f64, table[0]);
        assert!(seven_digits(row.rf2, table[1]), "k {k}: RF2 {} {}", row.rf2, table[1]);
        assert!(seven_digits(rub.rf2, table[2]), "k {k}: RF2 {} {}", rub.rf2, table[2]);
        assert!(seven_digits(row.contact_length.unwrap() * 1e3, table[3]), "k {k}: xi_L");
        let u = problem
            .equilibrium(row.u2, 0.0, Reference::Linear, slideline_theory::Stroke::Push)
            .unwrap()
            .unwrap();
        let depth = circle_side(&problem, u.point);
        assert!((depth * 1e3 - table[4]).abs() < 0.51e-6, "k {k}: u {depth}");
        assert!(seven_digits(row.force, table[5]), "k {k}: F {}", row.force);
        assert!(
            (row.time - k as f64 / 20.0).abs() < 1e-15
                && (row.u2 + 1.5e-3 * k as f64).abs() < 1e-17
        );
    }
}

/// Distance of a point from the undeformed beam, positive towards the circle.
fn circle_side(problem: &FirstProblem, point: [f64; 2]) -> f64 {
    let beam = problem.beam;
    let (dx, dy) = (beam.tip[0] - beam.base[0], beam.tip[1] - beam.base[1]);
    (-dy * (point[0] - beam.base[0]) + dx * (point[1] - beam.base[1])) / beam.length()
}

/// Requirement: every row of the table, to all digits shown; the first two carry nothing.
#[test]
fn second_problem_table() {
    let problem = SecondProblem::project();
    let free = problem.rows(0.0, 20, Reference::Linear).unwrap();
    let rubbing = problem.rows(0.3, 20, Reference::Linear).unwrap();
    for row in free[..2].iter().chain(&rubbing[..2]) {
        assert_eq!((row.rm3, row.force, row.contact_length), (0.0, 0.0, None));
    }
    for table in &SECOND {
        let (row, rub) = (free[table[0] as usize], rubbing[table[0] as usize]);
        assert!(seven_digits(row.rm3, table[1]), "{table:?}: {}", row.rm3);
        assert!(seven_digits(rub.rm3, table[2]), "{table:?}: {}", rub.rm3);
        assert!(seven_digits(row.contact_length.unwrap() * 1e3, table[3]), "{table:?}");
        let found =
            problem.equilibrium(row.ur3, 0.0, Reference::Linear, slideline_theory::Stroke::Push);
        assert!((found.unwrap().unwrap().point[1] * 1e3 - table[4]).abs() < 0.51e-6, "{table:?}");
        assert!(seven_digits(row.force, table[5]), "{table:?}: {}", row.force);
    }
}
