//! Maps of other programs: what they say is what the scene says, and no file, however broken, does worse than an error.

use parkade::error::ErrorCode;
use parkade::geometry::Point;
use parkade::import::{File, Imported, Options, import};
use parkade::map::{Frame, Occupancy, raster};
use parkade::scenario::{Obstacle, Scenario};

mod files;
mod movingai;
mod rosmap;

const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n.@GT\nS...\nO..W\n";
const SCEN: &str =
    "version 1\n0\tmaps/room.map\t4\t3\t0\t0\t2\t0\t3.41421356\n1 room.map 4 3 1 2 3 1 2.41421\n";
const YAML: &str = "image: lot.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: \
    0.65\nfree_thresh: 0.196\n";
const P2: &str = "P2\n# drawn by hand\n3 2\n255\n0 254 254\n205 254 0\n";

fn file<'a>(name: &'a str, text: &'a str) -> File<'a> {
    File { name, bytes: text.as_bytes() }
}

fn read(files: &[(&str, &str)]) -> Imported {
    let files: Vec<File> = files.iter().map(|&(name, text)| file(name, text)).collect();
    import(&files, &Options::default()).unwrap()
}

fn refused(files: &[(&str, &str)]) -> String {
    let files: Vec<File> = files.iter().map(|&(name, text)| file(name, text)).collect();
    let error = import(&files, &Options::default()).unwrap_err();
    assert_eq!(error.code, ErrorCode::Import);
    error.to_string()
}

fn frame(scene: &Scenario) -> Frame {
    let map = &scene.map;
    Frame {
        origin: Point::new(map.origin[0], map.origin[1]),
        width: map.width,
        height: map.height,
        resolution: map.resolution,
    }
}

fn cells(scene: &Scenario) -> Occupancy {
    let mut map = Occupancy::new(scene.map.width, scene.map.height);
    let Obstacle::Cells { runs, .. } = &scene.obstacles[0] else { panic!("cells") };
    raster::runs(&mut map, runs);
    map
}
