package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.roads.geo.GeoReference;
import dev.eventchain.roads.road.Pose;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests places by latitude and longitude. */
class GeoReferenceTest {

  /**
   * Values of PROJ 9 by pyproj (some on GRS 80, which is 0.2 mm off), and the length of a quarter
   * of a meridian.
   */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "+proj=tmerc +lat_0=48.5 +lon_0=11.25 +k=0.9996 +x_0=500000 +y_0=-1000 +datum=WGS84"
            + " +units=m +no_defs | 48.7758 | 11.4283 | 513099.743226 | 29672.771921",
        "+proj=tmerc +lat_0=4.85e1 +lon_0=11.25 +k_0=0.9996 +x_0=500000 +y_0=-1000"
            + " +ellps=GRS80 | 52.52 | 13.405 | 646212.701143 | 448183.569227",
        "+proj=utm +zone=32 +ellps=GRS80 +units=m +no_defs | 52.52 | 13.405 | 798812.802574"
            + " | 5827999.899986",
        "+proj=utm +zone=32 +datum=WGS84 +vunits=m +geoidgrids=egm96_15.gtx +type=crs"
            + " | 60 | 14.9 | 828796.993396 | 6666091.488746",
        "+proj=utm +zone=56 +south +datum=WGS84 | -33.8688 | 151.2093 | 334368.633648"
            + " | 6250948.345385",
        "+proj=tmerc +lat_0=0 +lon_0=0 | 90 | 0 | 0 | 10001965.729313",
        "+proj=tmerc +lat_0=10 +lon_0=3 +x_0=7 +y_0=8 | 10 | 3 | 7 | 8",
      })
  void projects(String text, double latitude, double longitude, double east, double north) {
    GeoReference reference = new GeoReference(text);
    assertEquals(Optional.empty(), reference.problem());
    double[] place = reference.project(latitude, longitude);
    assertEquals(east, place[0], 5e-4);
    assertEquals(north, place[1], 5e-4);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | there is none",
        "EPSG:25832 | `EPSG:25832` is no PROJ string",
        "+proj=merc +lon_0=0 | the projection `merc` is not known, only `tmerc` and `utm` are",
        "+zone=32 | the projection `` is not known, only `tmerc` and `utm` are",
        "+proj=tmerc +lon_0=x | `lon_0=x` is no number",
        "+proj=tmerc +ellps=bessel | `+ellps=bessel` is not known",
        "+proj=tmerc +towgs84=598.1,73.7,418.2 | `+towgs84=598.1,73.7,418.2` is not known",
        "+proj=tmerc +units=us-ft | `+units=us-ft` is not known",
        "+proj=tmerc +south | `+south` is not known",
        "+proj=utm +zone=61 | `utm` needs a `zone` from 1 to 60",
        "+proj=utm | `utm` needs a `zone` from 1 to 60",
      })
  void refusesWhatItDoesNotKnow(String text, String problem) {
    assertEquals(problem, new GeoReference(text).problem().orElseThrow());
  }

  /** The offset of the file turns by 0.5 rad and then moves by (1000, 2000, 3). */
  @Test
  void placesAreThoseOfTheFile() {
    RoadNetwork network = Networks.read("tilted");
    assertEquals(Optional.empty(), network.geoProblem());
    Pose place = network.geo(52.52, 13.405, 10);
    assertEquals(798812.802574, 1000 + place.x() * Math.cos(0.5) - place.y() * Math.sin(0.5), 5e-4);
    assertEquals(
        5827999.899986, 2000 + place.x() * Math.sin(0.5) + place.y() * Math.cos(0.5), 5e-4);
    assertEquals(7, place.z());
    assertTrue(Networks.read("crossing").geoProblem().isPresent());
  }
}
