package dev.eventchain.simulation.bench;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.FieldType.Kind;
import dev.eventchain.messages.FieldType.Shape;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import dev.eventchain.simulation.world.ActorKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Proposes the section {@code objects} for a message with sequences or arrays, which are taken for
 * those of a list of objects. Values are recognised by the names of their fields.
 */
final class ObjectsProposal {

  /** Rule that recognises a value by the end of its path. */
  private record Guess(Pattern name, Property property) {}

  private static final List<Guess> GUESSES =
      List.of(
          guess("(^|[._])id$|track_id", Property.ID),
          guess("class|label|category|object_type", Property.CLASS),
          guess("range_rate|doppler", Property.RANGE_RATE),
          guess("relative_?(speed|velocity)|(distance|gap)_rate", Property.RELATIVE_SPEED),
          guess(
              "(velocity|linear|speed)[._](y|lat)|lateral_(speed|velocity)",
              Property.LATERAL_SPEED),
          guess("(velocity|linear)[._](x|long)|speed|velocity$", Property.SPEED),
          guess("orientation[._]z", Property.ORIENTATION_Z),
          guess("orientation[._]w", Property.ORIENTATION_W),
          guess("heading|(^|[._])yaw$", Property.HEADING),
          guess("azimuth|bearing", Property.AZIMUTH),
          guess("(dimensions|size)[._]x|length", Property.LENGTH),
          guess("(dimensions|size)[._]y|width", Property.WIDTH),
          guess("(dimensions|size)[._]z|height", Property.HEIGHT),
          guess("lateral|offset", Property.LATERAL),
          guess("distance|gap", Property.DISTANCE),
          guess("(^|[._])range$", Property.RANGE),
          guess("(^|[._])x$", Property.X),
          guess("(^|[._])y$", Property.Y));

  private static final Pattern COUNT = Pattern.compile("(^|_)(num|count|number)(_|$)");

  private static final int DEEPEST = 4;

  private final MessageType type;
  private final List<String> fields = new ArrayList<>();
  private boolean any;
  private boolean listsMessages;

  private ObjectsProposal(MessageType type) {
    this.type = type;
  }

  private static Guess guess(String name, Property property) {
    return new Guess(Pattern.compile(name), property);
  }

  /**
   * Returns the lines of the section, those of unknown values as comments.
   *
   * @param topic its words say where the sensor looks
   * @param units the units of fields as the project states them
   * @return empty if the message holds nothing that looks like a property of objects
   */
  static Optional<List<String>> of(String topic, MessageType type, DeclaredUnits units) {
    ObjectsProposal proposal = new ObjectsProposal(type);
    type.fields().stream()
        .filter(field -> field.type().shape() != Shape.SINGLE)
        .sorted(Comparator.comparing(field -> field.type().message().isEmpty()))
        .forEach(field -> proposal.list(field, units));
    if (!proposal.any) {
      return Optional.empty();
    }
    List<String> lines = new ArrayList<>();
    lines.add("    objects:");
    direction(topic).ifPresent(lines::add);
    proposal.count().ifPresent(path -> lines.add("      count: " + path));
    lines.add("      fields:");
    lines.addAll(proposal.fields);
    return Optional.of(lines);
  }

  /** The units that the project states for fields. */
  interface DeclaredUnits {
    Optional<String> of(String path);
  }

  /** Returns the line that says where a sensor looks, as its topic is named; empty for ahead. */
  static Optional<String> direction(String topic) {
    String name = topic.toLowerCase(Locale.ROOT);
    if (name.matches(".*(rear|back|behind).*")) {
      return Optional.of("      direction_deg: 180");
    } else if (name.contains("left")) {
      return Optional.of("      direction_deg: 90");
    } else if (name.contains("right")) {
      return Optional.of("      direction_deg: -90");
    }
    return name.matches(".*(around|surround|360).*")
        ? Optional.of("      view_deg: 360")
        : Optional.empty();
  }

  private Optional<String> count() {
    return type.fields().stream()
        .filter(field -> ListedFields.isInteger(field.type()))
        .filter(field -> COUNT.matcher(field.name().toLowerCase(Locale.ROOT)).find())
        .map(MessageType.Field::name)
        .findFirst();
  }

  private void list(MessageType.Field field, DeclaredUnits units) {
    Optional<MessageType> element = field.type().message();
    if (element.isPresent()) {
      inner(field.name() + "[].", "", element.get(), 1);
      listsMessages |= any;
    } else if (listsMessages) {
      // Beside a list of messages, arrays are of something else.
      fields.add("#        " + field.name() + ": ?");
    } else {
      add(field.name(), field.name(), field.type(), type, units.of(field.name()));
    }
  }

  private void inner(String prefix, String path, MessageType owner, int depth) {
    for (MessageType.Field field : owner.fields()) {
      String name = path + field.name();
      Optional<MessageType> nested = field.type().message();
      if (field.type().shape() != Shape.SINGLE || name.equals("header")) {
        continue;
      }
      if (nested.isPresent() && depth < DEEPEST) {
        inner(prefix, name + ".", nested.get(), depth + 1);
      } else if (nested.isEmpty()) {
        add(prefix + name, name, field.type(), owner, Optional.empty());
      }
    }
  }

  private void add(
      String path, String name, FieldType field, MessageType owner, Optional<String> unit) {
    String lower = name.toLowerCase(Locale.ROOT);
    Optional<Property> property =
        GUESSES.stream()
            .filter(guess -> guess.name().matcher(lower).find())
            .map(Guess::property)
            .filter(it -> takes(field, it) && fits(it, unit))
            .findFirst();
    boolean numbered = property.equals(Optional.of(Property.CLASS)) && field.kind() != Kind.STRING;
    Optional<String> value = numbered ? classes(owner) : property.map(Property::id);
    any |= value.isPresent();
    fields.add(value.map(it -> "        " + path + ": " + it).orElse("#        " + path + ": ?"));
  }

  private static boolean takes(FieldType field, Property property) {
    boolean whole = field.kind() != Kind.BOOL && field.kind() != Kind.STRING;
    return switch (property) {
      case ID -> whole && !ObjectsReader.isFloat(field);
      case CLASS -> field.kind() == Kind.STRING || (whole && !ObjectsReader.isFloat(field));
      default -> ObjectsReader.isFloat(field);
    };
  }

  private static boolean fits(Property property, Optional<String> unit) {
    return unit.flatMap(Unit::parse)
        .map(it -> it.relationTo(property.unit()))
        .map(it -> it == Unit.Relation.SAME || it == Unit.Relation.CONVERTIBLE)
        .orElse(true);
  }

  /** Returns the numbers of the kinds whose names are constants of a message. */
  private static Optional<String> classes(MessageType owner) {
    String known =
        owner.constants().stream()
            .filter(each -> each.value() instanceof Number)
            .flatMap(
                each ->
                    Arrays.stream(ActorKind.values())
                        .filter(kind -> isNamed(each.name(), kind))
                        .map(kind -> kind.id() + ": " + each.value()))
            .distinct()
            .collect(Collectors.joining(", "));
    return known.isEmpty()
        ? Optional.empty()
        : Optional.of("{value: class, classes: {" + known + "}}");
  }

  private static boolean isNamed(String constant, ActorKind kind) {
    String name = constant.toLowerCase(Locale.ROOT);
    return switch (kind) {
      case CAR -> name.matches("(.*_)?(car|vehicle)");
      case LORRY -> name.matches("(.*_)?(lorry|truck)");
      case MOTORCYCLE -> name.matches("(.*_)?(motorcycle|motorbike)");
      default -> name.matches("(.*_)?" + kind.id());
    };
  }
}
