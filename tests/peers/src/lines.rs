//! Seeded generator of the files that are raced: mixed GNSS, bridge and track control.

#[path = "../../random.rs"]
mod random;

pub(crate) use random::Random;

impl Random {
    fn tenths(&mut self, limit: u64) -> String {
        let tenths = self.below(limit * 10);
        format!("{}.{}", tenths / 10, tenths % 10)
    }
    fn position(&mut self) -> String {
        format!(
            "{:02}{:02}.{:04},{},{:03}{:02}.{:04},{}",
            self.below(90),
            self.below(60),
            self.below(10_000),
            self.pick(&["N", "S"]),
            self.below(180),
            self.below(60),
            self.below(10_000),
            self.pick(&["E", "W"]),
        )
    }
    fn time(&mut self) -> String {
        format!(
            "{:02}{:02}{:02}.{:02}",
            self.below(24),
            self.below(60),
            self.below(60),
            self.below(100)
        )
    }
}

/// A sentence of the GNSS file: GGA, RMC, VTG, GLL.
pub fn gnss(r: &mut Random) -> String {
    let talker = r.pick(&["GP", "GN", "GL"]);
    match r.below(4) {
        0 => format!(
            "{talker}GGA,{},{},{},{:02},{}.{},{},M,{},M,,",
            r.time(),
            r.position(),
            1 + r.below(2),
            r.below(13),
            r.below(3),
            r.below(10),
            r.tenths(100),
            r.tenths(50)
        ),
        1 => format!(
            "{talker}RMC,{},A,{},{},{},{:02}{:02}{:02},{},{},A",
            r.time(),
            r.position(),
            r.tenths(30),
            r.tenths(360),
            1 + r.below(28),
            1 + r.below(12),
            r.below(100),
            r.tenths(20),
            r.pick(&["E", "W"])
        ),
        2 => {
            let knots = r.tenths(30);
            format!(
                "{talker}VTG,{},T,{},M,{knots},N,{},K,A",
                r.tenths(360),
                r.tenths(360),
                r.tenths(55)
            )
        }
        _ => format!("{talker}GLL,{},{},A,A", r.position(), r.time()),
    }
}

/// A sentence of the bridge file: what both decoders know.
pub fn bridge(r: &mut Random) -> String {
    match r.below(24) {
        0 => format!(
            "EIXTE,A,A,0.{:03},{},N,A",
            r.below(1000),
            r.pick(&["L", "R"])
        ),
        1 => format!(
            "EIAPB,A,A,0.{:03},{},N,V,V,{},T,WP{:03},{},T,{},T,A",
            r.below(1000),
            r.pick(&["L", "R"]),
            r.tenths(360),
            r.below(1000),
            r.tenths(360),
            r.tenths(360)
        ),
        2 | 3 => format!("HEHDT,{},T", r.tenths(360)),
        4 | 5 => format!("HEROT,-{},A", r.tenths(60)),
        6 => format!(
            "VDVHW,{},T,{},M,{},N,{},K",
            r.tenths(360),
            r.tenths(360),
            r.tenths(30),
            r.tenths(55)
        ),
        7 => format!("AGRSA,-{},A,,V", r.tenths(35)),
        8 => format!(
            "RATTM,{:02},{},{},T,{},{},T,{},{},N,T{:02},T,,{},A",
            r.below(99),
            r.tenths(12),
            r.tenths(360),
            r.tenths(25),
            r.tenths(360),
            r.tenths(5),
            r.tenths(60),
            r.below(99),
            r.time()
        ),
        9 => format!("HETHS,{},A", r.tenths(360)),
        10 => format!("HCHDG,{},1.5,E,3.5,W", r.tenths(360)),
        11 => format!("HCHDM,{},M", r.tenths(360)),
        12 => format!(
            "SDDBT,{},f,{},M,{},F",
            r.tenths(300),
            r.tenths(100),
            r.tenths(50)
        ),
        13 => format!("SDDPT,{},-1.5,200.0", r.tenths(100)),
        14 => format!("WIMWV,{},R,{},N,A", r.tenths(360), r.tenths(60)),
        15 => format!(
            "WIMWD,{},T,{},M,{},N,{},M",
            r.tenths(360),
            r.tenths(360),
            r.tenths(60),
            r.tenths(30)
        ),
        16 => format!("YXMTW,{},C", r.tenths(30)),
        17 => format!("VDVBW,{},-0.1,A,{},0.2,A", r.tenths(20), r.tenths(20)),
        18 => format!("VDVLW,{},N,{},N", r.tenths(9000), r.tenths(100)),
        19 => format!(
            "EIBOD,{},T,{},M,WP{:03},WP{:03}",
            r.tenths(360),
            r.tenths(360),
            r.below(999),
            r.below(999)
        ),
        20 => format!(
            "EIBWC,{},{},{},T,{},M,{},N,WP{:03},A",
            r.time(),
            r.position(),
            r.tenths(360),
            r.tenths(360),
            r.tenths(99),
            r.below(999)
        ),
        21 => format!(
            "GPZDA,{},{:02},{:02},20{:02},00,00",
            r.time(),
            1 + r.below(28),
            1 + r.below(12),
            r.below(38)
        ),
        22 => format!("ERRPM,E,1,{},{},A", r.tenths(200), r.tenths(99)),
        _ => format!("EIHSC,{},T,{},M", r.tenths(360), r.tenths(360)),
    }
}

/// A sentence of the track-control file; the rival knows about half of these.
pub fn tcs(r: &mut Random) -> String {
    match r.below(10) {
        0 => format!(
            "EIHTC,V,,,T,R,,,0.{:02},,,,{},T,C",
            r.below(99),
            r.tenths(360)
        ),
        1 => format!(
            "AGHTD,V,{},R,T,R,35.0,20.0,0.{:02},0{:02}.5,{},,{},T,A,A,,{}",
            r.tenths(35),
            r.below(99),
            r.below(99),
            r.tenths(360),
            r.tenths(360),
            r.tenths(360)
        ),
        2 => format!("EIXTE,A,A,0.{:03},L,N,A", r.below(1000)),
        3 => format!("PNEY,001,A,A,0.{:03},L,N,A", r.below(1000)),
        4 => format!("PNEY,002,{},{:03}", r.position(), r.below(999)),
        5 => format!("EIGLL,{},{},A,A", r.position(), r.time()),
        6 => format!(
            "EIVTG,{},T,,M,{},N,{},K,A",
            r.tenths(360),
            r.tenths(30),
            r.tenths(55)
        ),
        7 => format!(
            "EIVHW,{},T,{},M,{},N,{},K",
            r.tenths(360),
            r.tenths(360),
            r.tenths(30),
            r.tenths(55)
        ),
        8 => format!("AGROR,{},A,,V,B", r.tenths(35)),
        _ => format!("HEHDT,{},T", r.tenths(360)),
    }
}
