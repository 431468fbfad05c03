package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.sensor.LaserScanner;
import java.util.Locale;

/** Reads the section {@code laser_scan} of a topic. */
final class LaserScanReader {

  static final String MESSAGES = "sensor_msgs/msg/LaserScan";

  private static final NumberRange RANGE = NumberRange.of(1, 500);
  private static final NumberRange NEAREST = NumberRange.of(0, 10);
  private static final NumberRange VIEW = NumberRange.of(1, 360);
  private static final NumberRange STEP = NumberRange.of(0.05, 30);
  private static final NumberRange HEIGHT = NumberRange.of(0.05, 3);
  private static final NumberRange NOISE = NumberRange.of(0, 10);

  /** In a second. */
  private static final double MOST_RAYS = 100_000;

  private LaserScanReader() {}

  /**
   * Reads the section.
   *
   * @param rate of the scans, in Hz
   */
  static LaserScanner read(ObjectReader section, double rate) {
    double range = section.number("range_m", RANGE).orElse(30);
    double nearest = section.number("nearest_m", NEAREST).orElse(0.1);
    double view = section.number("view_deg", VIEW).orElse(180);
    double step = section.number("step_deg", STEP).orElse(0.5);
    if (nearest >= range) {
      refuse(section, "The nearest distance is not less than the range.", "");
    } else if (step > view) {
      refuse(section, "The step is larger than the view.", "");
    }
    LaserScanner scanner =
        new LaserScanner(
            MountingReader.read(section),
            range,
            nearest,
            StrictMath.toRadians(view / 2),
            StrictMath.toRadians(step),
            section.number("height_m", HEIGHT).orElse(0.5),
            section.number("noise_m", NOISE).orElse(0));
    section.refuseOthers();
    if (scanner.rays() * rate > MOST_RAYS) {
      refuse(
          section,
          String.format(
              Locale.ROOT, "These are %d rays, %s times in a second.", scanner.rays(), rate),
          "At most 100000 rays a second are simulated: enlarge `step_deg`.");
    }
    return scanner;
  }

  private static void refuse(ObjectReader section, String message, String hint) {
    section.find(
        Diagnostic.of(BenchRules.BENCH_VALUE_RANGE, message, section.location()).withHint(hint));
  }
}
