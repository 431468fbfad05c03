package dev.eventchain.simulation.bench;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.Signal.Field;
import dev.eventchain.simulation.world.Actuator;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Proposes a bench for described signals. Fields recognised by name and unit are connected; the
 * others are in comments, so that a check reports a chain that reads them.
 */
final class BenchProposal {

  /** Rule that recognises a field by its name and the dimension of its unit. */
  private record Guess(Pattern name, String quantity, String unit) {

    static Guess of(String name, String quantity, String unit) {
      return new Guess(Pattern.compile(name), quantity, unit);
    }
  }

  private static final List<Guess> QUANTITIES =
      List.of(
          Guess.of(
              "(range|distance|gap).*rate|relative.*(speed|velocity)",
              "lead.speed - ego.speed",
              "m/s"),
          Guess.of("(lead|target|object).*(speed|velocity)", "lead.speed", "m/s"),
          Guess.of("speed|velocity|twist.linear.x", "ego.speed", "m/s"),
          Guess.of("linear_acceleration.y|lateral.*accel", "ego.acceleration.left", "m/s2"),
          Guess.of("accel", "ego.acceleration", "m/s2"),
          Guess.of("latitude", "ego.latitude", "deg"),
          Guess.of("longitude", "ego.longitude", "deg"),
          Guess.of("range|distance|gap|headway", "min(gap, 200 m)", "m"),
          Guess.of("ttc|time_to_collision", "min(ttc, 1000 s)", "s"),
          Guess.of("offset|lateral", "ego.offset", "m"),
          Guess.of("position.x", "ego.x", "m"),
          Guess.of("position.y", "ego.y", "m"),
          Guess.of("odometer", "ego.position", "m"),
          Guess.of("yaw_rate|angular.z", "ego.yaw_rate", "rad/s"),
          Guess.of("heading", "ego.heading", "rad"),
          Guess.of("yaw", "ego.yaw", "rad"));

  private static final double USUAL_RATE = 20;
  private static final double MOST_RATE = 1000;

  /** Entry of a topic that has no effect, or none that could be guessed. */
  private static final String UNUSED = "observed: true";

  /** Entries whose lines mean nothing without those around them. */
  private static final Pattern NESTED = Pattern.compile("^#? *(laser_scan|objects):$");

  /** Lines that nobody but the maker of a robot can complete, which a bench with a speed needs. */
  private static final String FOLLOWING =
      """
      # How the robot follows a commanded speed: say it here, without the signs of comments.
      #vehicle:
      #  maximal_acceleration_mps2: ?
      #  maximal_deceleration_mps2: ?
      #  command_timeout_s: ? # without commands it stops by itself after this time; 0 if it never does
      #  maximal_yaw_rate_radps: ? # of a robot that turns on the spot; leave it out for steered wheels
      """;

  /** Messages of a commanded motion. */
  private static final Pattern TWIST = Pattern.compile("geometry_msgs/msg/Twist(Stamped)?");

  private static final Pattern PRESENT = Pattern.compile("valid|present|detected");

  private final List<dev.eventchain.model.Signal> signals;
  private final MessageCatalog catalog;
  private final Map<String, Double> rates;
  private final StringBuilder text = new StringBuilder();

  /** The actuators that topics drive so far: a vehicle follows one topic for each. */
  private final Set<Actuator> driven = EnumSet.noneOf(Actuator.class);

  /** The lines for the first number or Boolean that could not be guessed. */
  private Optional<String> inputs = Optional.empty();

  /**
   * Creates a proposal.
   *
   * @param rates what is known of the rates of topics, in Hz, by their full names
   */
  BenchProposal(
      List<dev.eventchain.model.Signal> signals,
      MessageCatalog catalog,
      Map<String, Double> rates) {
    this.signals = signals;
    this.catalog = catalog;
    this.rates = rates;
  }

  String text() {
    text.append(
        "# How the simulated road and this project are connected; `eventchain bench DIR` lists\n");
    text.append("# what there is. What is commented out could not be guessed.\n");
    int head = text.length();
    section("provides:", Direction.PROVIDED);
    section("consumes:", Direction.CONSUMED);
    inputs.ifPresent(lines -> text.insert(head, lines));
    if (signals.stream().anyMatch(BenchProposal::commandsSpeed)) {
      text.insert(head, FOLLOWING);
    }
    return text.toString();
  }

  /** Returns what a proposal says of the fields of a signal; none if it could guess nothing. */
  List<String> guesses(dev.eventchain.model.Signal signal) {
    boolean isProvided = signal.direction() == Direction.PROVIDED;
    List<String> lines = isProvided ? provided(signal) : consumed(signal);
    boolean isNested = lines.stream().anyMatch(NESTED.asPredicate());
    return lines.stream()
        .skip(isProvided ? 2 : 1) // the topic, and its rate
        .filter(line -> !isNested && !line.startsWith("#") && !line.endsWith(":"))
        .map(String::strip)
        .filter(line -> !line.equals(UNUSED))
        .toList();
  }

  /**
   * Returns an example of an input: a value that comes neither from the road nor from the vehicle.
   */
  private static String inputs(Field field, FieldType.Kind kind) {
    String name = "my." + field.path().replaceAll("\\W", "_");
    boolean isStated = !field.unit().matches("1?") && Unit.parse(field.unit()).isPresent();
    return """
        # What the road has not is an input, whose values scenarios set under `inputs`. Declare it here, and
        # give %s to the field in the place of the question mark:
        #   inputs:
        #     %s: {%svalue: 0}
        """
        .formatted(
            kind == FieldType.Kind.BOOL ? "`" + name + " > 0`" : "its name",
            name,
            isStated ? "unit: \"" + field.unit() + "\", " : "");
  }

  private void section(String heading, Direction direction) {
    List<String> lines = new ArrayList<>();
    signals.stream()
        .filter(signal -> signal.direction() == direction)
        .forEach(
            signal ->
                lines.addAll(
                    direction == Direction.PROVIDED ? provided(signal) : consumed(signal)));
    if (lines.isEmpty()) {
      text.append("# No signal of software-base/signals.json has \"direction\": \"")
          .append(direction.name().toLowerCase(Locale.ROOT))
          .append("\".\n");
    }
    boolean connected = lines.stream().anyMatch(line -> !line.startsWith("#"));
    text.append(heading).append(connected ? "\n" : " {}\n");
    lines.forEach(line -> text.append(line).append('\n'));
  }

  private List<String> provided(dev.eventchain.model.Signal signal) {
    List<String> lines = new ArrayList<>(List.of(topic(signal), "    rate_hz: " + rate(signal)));
    String type = RosNames.fullMessageType(signal.messageType());
    if (type.equals("sensor_msgs/msg/PointCloud2")) {
      lines.add("    sensor: lidar");
    } else if (type.equals(LaserScanReader.MESSAGES)) {
      lines.add("    laser_scan:");
      ObjectsProposal.direction(signal.topic()).ifPresent(lines::add);
      lines.add("      range_m: 30");
    } else {
      return withFields(signal, lines);
    }
    return lines;
  }

  /** Adds the fields of a topic; returns all lines as comments if none could be connected. */
  private List<String> withFields(dev.eventchain.model.Signal signal, List<String> topic) {
    Optional<List<String>> objects = objects(signal);
    List<String> fields = new ArrayList<>();
    for (Field field : single(signal, objects.isPresent())) {
      Optional<String> source =
          source(signal, field).or(() -> StandardState.source(signal, field.path()));
      if (source.isEmpty()) {
        inputs = inputs.or(() -> kind(signal, field.path()).map(kind -> inputs(field, kind)));
      }
      fields.add(
          source
              .map(it -> "      " + field.path() + ": " + it)
              .orElse("#      " + field.path() + ": " + unit(field)));
    }
    boolean any = fields.stream().anyMatch(line -> !line.startsWith("#"));
    List<String> lines = new ArrayList<>(topic);
    objects.ifPresent(lines::addAll);
    if (objects.isEmpty() || !fields.isEmpty()) {
      lines.add(any || objects.isEmpty() ? "    fields:" : "#    fields:");
    }
    lines.addAll(fields);
    return any || objects.isPresent() ? lines : commented(lines);
  }

  /** Returns the fields that need a source; without those in lists if objects fill these. */
  private List<Field> single(dev.eventchain.model.Signal signal, boolean hasObjects) {
    boolean onlyStamps =
        signal.fields().stream().allMatch(field -> BenchCheck.isStamp(field.path()));
    return signal.fields().stream()
        .filter(field -> !hasObjects || !isList(signal, field))
        .filter(field -> onlyStamps || !BenchCheck.isStamp(field.path()))
        .toList();
  }

  private Optional<List<String>> objects(dev.eventchain.model.Signal signal) {
    return catalog
        .find(signal.messageType())
        .flatMap(
            type ->
                ObjectsProposal.of(
                    signal.topic() + " " + type.name(),
                    type,
                    path ->
                        signal.fields().stream()
                            .filter(field -> field.path().equals(path))
                            .map(Field::unit)
                            .findFirst()));
  }

  private boolean isList(dev.eventchain.model.Signal signal, Field field) {
    return catalog
        .find(signal.messageType())
        .flatMap(type -> type.resolve(field.path()).type())
        .filter(type -> type.shape() != FieldType.Shape.SINGLE)
        .isPresent();
  }

  private static List<String> commented(List<String> lines) {
    return lines.stream().map(line -> line.startsWith("#") ? line : "#" + line).toList();
  }

  private static String topic(dev.eventchain.model.Signal signal) {
    return "  " + RosNames.resolve(signal.topic(), "") + ":";
  }

  /** Returns the rate of a topic, by default that of many sensors. */
  private String rate(dev.eventchain.model.Signal signal) {
    double known = rates.getOrDefault(RosNames.resolve(signal.topic(), ""), USUAL_RATE);
    double rate = Math.min(known, MOST_RATE);
    return rate == Math.rint(rate) ? String.valueOf((long) rate) : String.valueOf(rate);
  }

  private static String unit(Field field) {
    return field.unit().isEmpty() ? "?" : "? # " + field.unit();
  }

  private Optional<String> source(dev.eventchain.model.Signal signal, Field field) {
    String name = nameOf(signal, field);
    Optional<FieldType.Kind> kind = kind(signal, field.path());
    if (kind.equals(Optional.of(FieldType.Kind.BOOL))) {
      return PRESENT.matcher(name).find() ? Optional.of("lead.present") : Optional.empty();
    }
    return Unit.parse(field.unit())
        .filter(unit -> kind.isPresent())
        .flatMap(
            unit ->
                QUANTITIES.stream()
                    .filter(guess -> guess.name().matcher(name).find())
                    .filter(guess -> convertible(unit, guess.unit()))
                    .map(Guess::quantity)
                    .findFirst());
  }

  /**
   * Returns the name that describes a field: in messages of std_msgs, whose field is "data", that
   * of the topic.
   */
  private static String nameOf(dev.eventchain.model.Signal signal, Field field) {
    String name = field.path().equals("data") ? signal.topic() : field.path();
    return name.toLowerCase(Locale.ROOT);
  }

  private static boolean convertible(Unit unit, String other) {
    Unit.Relation relation = unit.relationTo(Unit.parse(other).orElseThrow());
    return relation == Unit.Relation.SAME || relation == Unit.Relation.CONVERTIBLE;
  }

  /** Returns the kind of a field with a single number or Boolean; empty for any other field. */
  private Optional<FieldType.Kind> kind(dev.eventchain.model.Signal signal, String path) {
    Optional<MessageType> type = catalog.find(signal.messageType());
    return type.flatMap(known -> known.resolve(path).type())
        .filter(BenchSignals::isNumberOrTruth)
        .map(FieldType::kind);
  }

  private List<String> consumed(dev.eventchain.model.Signal signal) {
    List<String> lines = new ArrayList<>(List.of(topic(signal)));
    if (signals.stream()
        .filter(BenchProposal::commandsSpeed)
        .findFirst()
        .equals(Optional.of(signal))) {
      lines.add("    fields:");
      signal.fields().forEach(field -> lines.add("      " + field.path() + ": " + twist(field)));
      return lines;
    }
    List<String> fields = new ArrayList<>();
    Set<Actuator> used = driven();
    int before = used.size();
    for (Field field : signal.fields()) {
      Optional<Actuator> actuator = actuator(signal, field);
      boolean free = actuator.isPresent() && used.stream().noneMatch(actuator.get()::excludes);
      actuator.filter(it -> free).ifPresent(used::add);
      fields.add("      " + field.path() + ": " + (free ? actuator.get().id() : "observed"));
    }
    if (used.size() == before) {
      lines.add("    " + UNUSED);
    } else {
      lines.add("    fields:");
      lines.addAll(fields);
    }
    return lines;
  }

  /** Returns the actuators that topics drive which are proposed already, or command a speed. */
  private Set<Actuator> driven() {
    signals.stream()
        .filter(BenchProposal::commandsSpeed)
        .findFirst()
        .ifPresent(
            signal -> {
              driven.add(Actuator.SPEED);
              if (signal.fields().stream().anyMatch(field -> twist(field).contains("yaw_rate"))) {
                driven.add(Actuator.YAW_RATE);
              }
            });
    return driven;
  }

  /** Returns whether the vehicle takes a speed from a signal. */
  private static boolean commandsSpeed(dev.eventchain.model.Signal signal) {
    return signal.direction() == Direction.CONSUMED
        && TWIST.matcher(RosNames.fullMessageType(signal.messageType())).matches()
        && signal.fields().stream().anyMatch(field -> twist(field).contains("speed"));
  }

  /** Returns what a field of a twist does, in the units that geometry_msgs has by REP 103. */
  private static String twist(Field field) {
    String unit = field.unit().isEmpty() ? ", unit: %s}" : "}";
    return switch (field.path().replaceFirst("^twist\\.", "")) {
      case "linear.x" -> "{drives: speed" + unit.formatted("m/s");
      case "angular.z" -> "{drives: yaw_rate" + unit.formatted("rad/s");
      default -> "observed";
    };
  }

  private Optional<Actuator> actuator(dev.eventchain.model.Signal signal, Field field) {
    String name = nameOf(signal, field);
    Optional<FieldType.Kind> kind = kind(signal, field.path());
    if (kind.isEmpty()) {
      return Optional.empty();
    }
    boolean truth = kind.get() == FieldType.Kind.BOOL;
    Unit unit = Unit.parse(field.unit().isEmpty() ? "1" : field.unit()).orElse(null);
    return List.of(
            Actuator.HAND_BRAKE,
            Actuator.ACCELERATION,
            Actuator.THROTTLE,
            Actuator.BRAKE,
            Actuator.STEERING,
            Actuator.REVERSE)
        .stream()
        .filter(each -> name.contains(stem(each)) && each.truth() == truth)
        .filter(each -> truth || (unit != null && convertible(unit, each.unitText())))
        .findFirst();
  }

  private static String stem(Actuator actuator) {
    return actuator == Actuator.STEERING ? "steer" : actuator.id();
  }
}
