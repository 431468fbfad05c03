package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.RosNames;
import dev.eventchain.simulation.sensor.LaserScanner;
import dev.eventchain.simulation.sensor.ObjectSensor;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Finds topics whose messages would be filled twice. */
final class SensorConflicts {

  private SensorConflicts() {}

  /** Refuses several sensors for one topic, and fields that the sensor of the topic fills. */
  static void refuse(
      ObjectReader topic,
      List<Bench.Field> fields,
      Optional<ObjectSensor> objects,
      Optional<LaserScanner> scanner) {
    List<String> sensors = Stream.of("sensor", "laser_scan", "objects").filter(topic::has).toList();
    if (sensors.size() > 1) {
      topic.find(
          Diagnostic.of(
                  BenchRules.BENCH_KEY_DUPLICATE,
                  "The messages of one topic come from one sensor, not from `%s`."
                      .formatted(String.join("` and `", sensors)),
                  topic.at(sensors.get(1)))
              .withHint("Keep one of them, or give the others a topic of their own."));
    }
    List<String> filled = new ArrayList<>();
    objects.ifPresent(it -> it.paths().forEach(path -> filled.add(path.replaceFirst("\\[.*", ""))));
    scanner.ifPresent(it -> filled.addAll(LaserScanner.FILLED));
    for (Bench.Field field : fields) {
      if (filled.stream().anyMatch(path -> RosNames.overlap(path, field.path()))) {
        topic.find(
            BenchRules.BENCH_KEY_DUPLICATE,
            "'%s' is filled by the sensor of the topic.".formatted(field.path()),
            field.location());
      }
    }
  }
}
