package dev.eventchain.simulation.bench;

import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.bench.Bench.Consumed;
import dev.eventchain.simulation.bench.Bench.Effect;
import dev.eventchain.simulation.bench.Bench.Field;
import dev.eventchain.simulation.bench.Bench.Provided;
import dev.eventchain.simulation.formula.WorldSignals;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.world.Actuator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Lists the topics that a world provides and consumes, and a project's connections with them. */
final class BenchListing {

  private static final int NAME = 22;
  private static final int UNIT = 6;

  /** Most topics without a connection that are listed although the chain does not use them. */
  private static final int MOST_UNCONNECTED = 30;

  private final Bench bench;
  private final Optional<TopicIndex> topics;
  private final StringBuilder text = new StringBuilder();

  BenchListing(Bench bench, Optional<EventChain> chain) {
    this.bench = bench;
    this.topics = chain.map(TopicIndex::of);
  }

  String text() {
    line("The world has these quantities:");
    WorldSignals.all().forEach(it -> row(it.name(), it.truth() ? "" : it.unit(), it.meaning()));
    bench.signals().inputs().values().forEach(it -> row(it.name(), it.unit(), it.meaning()));
    line("and these sensors:");
    row("lidar", "", "roof lidar, sensor_msgs/msg/PointCloud2");
    row("laser_scan", "", "scanner in one plane, sensor_msgs/msg/LaserScan");
    row("objects", "", "list of the objects that are not completely hidden, with for each:");
    for (ObjectSensor.Property property : ObjectSensor.Property.values()) {
      row("  " + property.id(), property.unitText(), property.meaning());
    }
    line("The vehicle takes:");
    for (Actuator actuator : Actuator.values()) {
      row(actuator.id(), actuator.truth() ? "" : actuator.unitText(), actuator.meaning());
    }
    row("observed", "", "nothing; formulas may read it");
    line("");
    line("This project's topics:");
    bench.provided().values().stream().filter(it -> isUsed(it.topic())).forEach(this::provided);
    bench.consumed().values().stream().filter(it -> isUsed(it.topic())).forEach(this::consumed);
    unconnected(Direction.PROVIDED, bench.provided().keySet());
    unconnected(Direction.CONSUMED, bench.consumed().keySet());
    return text.toString();
  }

  private boolean isUsed(String topic) {
    return bench.isOwn(topic) || isOfChain(topic);
  }

  private boolean isOfChain(String topic) {
    return topics.flatMap(all -> all.find(topic)).isPresent();
  }

  private void provided(Provided topic) {
    line(
        "provides %s (%s, %s Hz)%s"
            .formatted(topic.topic(), topic.type(), plain(topic.rate()), readers(topic.topic())));
    if (topic.lidar()) {
      row("*", "", "scans of the lidar");
    }
    if (topic.scanner().isPresent()) {
      row("*", "", "scans of a laser scanner");
    }
    topic.objects().ifPresent(this::objects);
    for (Field field : topic.fields()) {
      if (field.source() instanceof Bench.Quantity quantity) {
        row(field.path(), "", quantity.text());
      } else if (field.source() instanceof Bench.Truth truth) {
        row(field.path(), "", truth.text());
      } else if (field.source() instanceof ChosenText chosen) {
        row(field.path(), "", chosen.text() + ": " + String.join(", ", chosen.texts()));
      } else if (field.source() instanceof Bench.Constant constant) {
        row(field.path(), "", "always " + constant.value());
      }
    }
  }

  private void objects(ObjectSensor sensor) {
    sensor
        .columns()
        .forEach(each -> row(each.path(), "", each.property().id() + " of each object"));
    sensor.constants().forEach(each -> row(each.path(), "", "always " + each.value()));
    sensor.count().ifPresent(path -> row(path, "", "number of objects"));
  }

  private void consumed(Consumed topic) {
    line("consumes %s (%s)%s".formatted(topic.topic(), topic.type(), writers(topic.topic())));
    for (Effect effect : topic.fields()) {
      String does = effect.actuator().map(Actuator::id).orElse("observed");
      row(effect.path(), "", does + (effect.required() ? ", required" : ""));
    }
    if (topic.fields().isEmpty()) {
      row("*", "", "observed");
    }
  }

  private void unconnected(Direction direction, java.util.Set<String> connected) {
    List<String> missing =
        bench.declared().names(direction).stream().filter(it -> !connected.contains(it)).toList();
    boolean provided = direction == Direction.PROVIDED;
    List<String> shown =
        missing.size() > MOST_UNCONNECTED
            ? missing.stream().filter(this::isOfChain).toList()
            : missing;
    if (shown.size() < missing.size()) {
      int more = missing.size() - shown.size();
      String what = provided ? "that the vehicle provides" : "that the vehicle takes";
      line(
          String.format(
              Locale.ROOT, "not connected: %d topics %s and the chain does not use", more, what));
    }
    for (String topic : shown) {
      line(
          "not connected: %s, %s%s"
              .formatted(
                  topic,
                  provided ? "which nothing provides" : "which nothing takes",
                  provided ? readers(topic) : writers(topic)));
    }
  }

  private String readers(String topic) {
    return topics
        .flatMap(all -> all.find(topic))
        .map(it -> ends(" -> ", it.subscribers()))
        .orElse("");
  }

  private String writers(String topic) {
    return topics
        .flatMap(all -> all.find(topic))
        .map(it -> ends(" <- ", it.publishers()))
        .orElse("");
  }

  private static String ends(String arrow, List<TopicIndex.Endpoint> ends) {
    return ends.isEmpty()
        ? ""
        : arrow
            + ends.stream()
                .map(it -> it.node().getName())
                .distinct()
                .collect(Collectors.joining(", "));
  }

  private static String plain(double number) {
    return number == Math.rint(number) ? String.valueOf((long) number) : String.valueOf(number);
  }

  private void row(String name, String unit, String meaning) {
    line("  %s  %s  %s".formatted(padded(name, NAME), padded(unit, UNIT), meaning));
  }

  private static String padded(String text, int width) {
    return text + " ".repeat(Math.max(0, width - text.length()));
  }

  private void line(String line) {
    text.append(line.stripTrailing()).append('\n');
  }
}
