//! Rasters and distances against oracles that are too simple to be wrong.

use crate::random_maps::random_map;
use parkade::geometry::Point;
use parkade::map::{Cell, Frame, Occupancy, distance, inflation, raster};
use parkade::scenario::generate::SplitMix64;

/// The least and the additional cells of a random map's sides.
const SIDES: [u32; 2] = [1, 24];

/// The transform that roads use, on 200 grids of all shapes, some without obstacles and some with nothing else.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn distances_are_those_of_brute_force() {
    let mut random = SplitMix64::new(200);
    for round in 0..200 {
        let mut side = |only: usize| if round % 10 == only { 1 } else { 1 + random.below(40) };
        let mut map = Occupancy::new(side(1), side(2));
        let share = [0, 1, 2, 10, 50, 99, 100][round % 7];
        let cells: Vec<Cell> = (0..map.len() as u32).map(|i| map.cell(i)).collect();
        for &cell in &cells {
            map.set(cell, random.below(100) < share);
        }
        let blocked: Vec<Cell> = cells.iter().copied().filter(|&c| map.blocked(c)).collect();
        let centers = distance::to_centers(&map, |quarters| quarters as f32);
        for &at in &cells {
            let squared = |b: &Cell| 4 * (i64::from(b.x - at.x).pow(2) + i64::from(b.y - at.y).pow(2));
            let nearest = blocked.iter().map(squared).min().unwrap_or(distance::NONE);
            assert_eq!(centers.get(at), Some(nearest as f32), "round {round}, {at:?}");
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn distances_and_inflation_are_exact() {
    let mut random = SplitMix64::new(40);
    for round in 0..60 {
        let (mut map, ..) = random_map(&mut random, SIDES, 45);
        if round == 0 {
            map = Occupancy::new(5, 4);
        }
        let blocked: Vec<Cell> =
            (0..map.len() as u32).map(|i| map.cell(i)).filter(|&c| map.blocked(c)).collect();
        let (centers, squares) = (distance::to_centers(&map, |d| d as f32), distance::to_squares(&map));
        let inflated = inflation::necessary(&map, 1.3);
        for index in 0..map.len() as u32 {
            let at = map.cell(index);
            let nearest = |side: fn(i64) -> i64| {
                let square =
                    |b: &Cell| side(i64::from(b.x - at.x)).pow(2) + side(i64::from(b.y - at.y)).pow(2);
                blocked.iter().map(square).min().unwrap_or(distance::NONE)
            };
            assert_eq!(centers.get(at), Some(nearest(|d| 2 * d) as f32));
            assert_eq!(squares.get(at), Some(nearest(|d| (2 * d.abs() - 1).max(0))));
            assert_eq!(
                inflated.blocked(at),
                (nearest(|d| (2 * d.abs() - 1).max(0)) as f64) < 4.0 * 1.3 * 1.3
            );
        }
    }
    let map = Occupancy::parse(".....\n.....\n..#..\n.....\n.....");
    let grown = [0.5, 0.51, 0.75, 1.5, 1.51].map(|radius| inflation::necessary(&map, radius).blocked_cells());
    assert_eq!(grown, [1, 5, 9, 9, 13]);
    let layer = inflation::layer(&map, &inflation::necessary(&map, 0.51));
    assert_eq!(
        (layer.get(Cell::new(2, 2)), layer.get(Cell::new(2, 3)), layer.get(Cell::new(3, 3))),
        (Some(1), Some(2), Some(0))
    );
}

/// Area of a simple polygon within a unit cell (Sutherland and Hodgman).
fn area_in_cell(outline: &[[f64; 2]], cell: Cell) -> f64 {
    let (x, y) = (f64::from(cell.x), f64::from(cell.y));
    let mut points = outline.to_vec();
    for (axis, bound, sign) in [(0, x, 1.0), (0, x + 1.0, -1.0), (1, y, 1.0), (1, y + 1.0, -1.0)] {
        let depth = |p: &[f64; 2]| sign * (p[axis] - bound);
        let mut kept = Vec::new();
        for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
            let (da, db) = (depth(a), depth(b));
            if da >= 0.0 {
                kept.push(*a);
            }
            if (da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0) {
                let t = da / (da - db);
                kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
            }
        }
        points = kept;
    }
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    pairs.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn outlines_block_what_they_overlap() {
    let frame = Frame { origin: Point::new(-3.7, 12.4), width: 20, height: 16, resolution: 0.3 };
    let mut random = SplitMix64::new(50);
    for round in 0..300 {
        // A star around a point is simple; every third one has corners on cell corners.
        let middle = [f64::from(random.below(24)) - 2.0, f64::from(random.below(20)) - 2.0];
        let outline: Vec<[f64; 2]> = (0..3 + random.below(8))
            .map(|_| (random.below(6283), 0.5 + f64::from(random.below(900)) / 100.0))
            .collect::<std::collections::BTreeMap<_, _>>()
            .into_iter()
            .map(|(angle, r)| {
                let (sin, cos) = parkade::geometry::math::sin_cos(f64::from(angle) / 1000.0);
                [middle[0] + r * cos, middle[1] + r * sin]
            })
            .map(|p| if round % 3 == 0 { p.map(f64::round) } else { p })
            .collect();
        let points: Vec<Point> = outline.iter().map(|p| frame.world([p[0] - 0.5, p[1] - 0.5])).collect();
        let (mut filled, mut outside) = (Occupancy::new(20, 16), Occupancy::new(20, 16));
        raster::fill(&mut filled, &frame, &points);
        raster::fill_outside(&mut outside, &frame, &points);
        for index in 0..filled.len() as u32 {
            let cell = filled.cell(index);
            let area = area_in_cell(&outline, cell);
            if area > 1e-6 {
                assert!(filled.blocked(cell), "{outline:?} {cell:?} {area}");
            } else if round % 3 != 0 && area == 0.0 {
                assert!(!filled.blocked(cell), "{outline:?} {cell:?}");
            }
            if area < 1.0 - 1e-6 {
                assert!(outside.blocked(cell), "{outline:?} {cell:?} {area}");
            } else if area > 1.0 - 1e-12 && round % 3 != 0 {
                assert!(!outside.blocked(cell), "{outline:?} {cell:?} {area}");
            }
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn walls_touch_and_rectangles_on_edges_do_not_leak() {
    let frame = Frame { origin: Point::new(-0.05, -0.05), width: 8, height: 6, resolution: 0.1 };
    let corners = [(0.25, 0.15), (0.45, 0.15), (0.45, 0.35), (0.25, 0.35)].map(|(x, y)| Point::new(x, y));
    let mut map = Occupancy::new(8, 6);
    raster::fill(&mut map, &frame, &corners);
    assert_eq!(raster::to_runs(&map), [[3, 2, 2], [3, 3, 2]]);

    let mut outside = Occupancy::new(8, 6);
    raster::fill_outside(&mut outside, &frame, &corners);
    assert_eq!(outside.blocked_cells(), 44);

    // Along an edge a wall touches the cells of both sides, and the cells that share its ends' corners.
    let mut wall = Occupancy::new(8, 6);
    raster::wall(&mut wall, &frame, &[Point::new(0.25, 0.15), Point::new(0.45, 0.15)]);
    assert_eq!(raster::to_runs(&wall), [[2, 1, 4], [2, 2, 4]]);

    let mut diagonal = Occupancy::new(8, 6);
    raster::wall(&mut diagonal, &frame, &[Point::new(0.0, 0.0), Point::new(0.2, 0.2)]);
    assert_eq!(raster::to_runs(&diagonal), [[0, 0, 2], [0, 1, 3], [1, 2, 2]]);

    let mut brushed = Occupancy::new(8, 6);
    raster::runs(&mut brushed, &[[6, 0, 9], [0, 9, 1]]);
    assert_eq!(raster::to_runs(&brushed), [[6, 0, 2]]);
}
