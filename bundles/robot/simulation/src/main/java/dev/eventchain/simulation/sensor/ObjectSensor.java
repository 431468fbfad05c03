package dev.eventchain.simulation.sensor;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/**
 * A list of the objects around, as from radars and cameras, the nearest first. Overhead structures
 * and flat plates are no objects. Objects wholly hidden behind others ({@link Sight}), as seen from
 * the sensor, are left out; walls, posts and the vehicle itself hide nothing. Where there are more
 * than a message can hold or count, it ends with the nearest of them.
 *
 * @param mounting where it is, and where it looks
 * @param range maximum distance, in m: along its direction, or with a view of more than half a
 *     circle to the nearest point
 * @param halfView half of the field of view, in rad
 * @param missed fraction of the objects that a message randomly omits, 0 to 1
 * @param columns what is said of each object
 * @param constants what is the same for each object
 * @param count the field that holds the number of the objects in the message
 */
public record ObjectSensor(
    Mounting mounting,
    double range,
    double halfView,
    double missed,
    List<Column> columns,
    List<Constant> constants,
    Optional<String> count) {

  /** Height of the sensor over the road, in m: behind the bumper, as for radars. Assumed. */
  private static final double MOUNTED = 0.5;

  private static final int ALL = Integer.MAX_VALUE;

  public ObjectSensor {
    columns = List.copyOf(columns);
    constants = List.copyOf(constants);
  }

  /**
   * Quantities of a column, in the frame of the sensor: x in its direction, y to the left of it. A
   * sensor in the middle of the front bumper looks along the vehicle's axis.
   */
  public enum Property {
    ID("1", "number of the object, the same in all messages"),
    DISTANCE("m", "in the sensor's direction to the object's nearest point; negative behind"),
    LATERAL("m", "its middle to the left of the sensor's direction"),
    RELATIVE_SPEED("m/s", "in the sensor's direction, negative if it comes nearer"),
    SPEED("m/s", "in the sensor's direction, over ground"),
    LATERAL_SPEED("m/s", "to the left of the sensor's direction, over ground"),
    X("m", "its middle, in the sensor's direction"),
    Y("m", "its middle, to the left of the sensor's direction"),
    RANGE("m", "from the sensor to the object's nearest point"),
    AZIMUTH("rad", "direction of its middle, to the left of the sensor's"),
    RANGE_RATE("m/s", "change of the distance to its middle"),
    HEADING("rad", "its front, to the left of the sensor's direction"),
    ORIENTATION_Z("1", "z of its heading as a quaternion"),
    ORIENTATION_W("1", "w of its heading as a quaternion"),
    CLASS("1", "what it is: a string field gets its kind, another one the number in classes"),
    LENGTH("m", "its length"),
    WIDTH("m", "its width"),
    HEIGHT("m", "its height");

    private final String unitText;
    private final String meaning;

    Property(String unitText, String meaning) {
      this.unitText = unitText;
      this.meaning = meaning;
    }

    public static Optional<Property> find(String id) {
      return Arrays.stream(values()).filter(each -> each.id().equals(id)).findFirst();
    }

    public static List<String> ids() {
      return Arrays.stream(values()).map(Property::id).toList();
    }

    /** Returns the name in a bench. */
    public String id() {
      return name().toLowerCase(Locale.ROOT);
    }

    public Unit unit() {
      return Unit.parse(unitText).orElseThrow();
    }

    public String unitText() {
      return unitText;
    }

    /** Returns the description for users. */
    public String meaning() {
      return meaning;
    }
  }

  /**
   * Returns whether a field may be another one for other objects, apart from their numbers.
   *
   * @param path as the bench has it, {@code objects[].width} in a list of messages
   */
  public boolean varies(String path) {
    return columns.stream()
        .filter(each -> each.property() != Property.ID)
        .anyMatch(each -> path.equals(each.path()));
  }

  /**
   * A field of the message.
   *
   * @param unit the unit of the field
   * @param noise standard deviation, in the field's unit
   * @param classes the values of {@link Property#CLASS}; empty for the names of the kinds
   */
  public record Column(
      String path, Property property, Unit unit, double noise, Map<ActorKind, Integer> classes) {

    /** Creates a column of a number. */
    public Column(String path, Property property, Unit unit, double noise) {
      this(path, property, unit, noise, Map.of());
    }
  }

  /** A field that is the same for each object. */
  public record Constant(String path, Object value) {}

  /** Returns the fields that are filled. */
  public List<String> paths() {
    return Stream.of(
            columns.stream().map(Column::path),
            constants.stream().map(Constant::path),
            count.stream())
        .flatMap(each -> each)
        .toList();
  }

  /** Returns the lists of messages that are filled. */
  public List<String> messageLists() {
    return paths().stream()
        .map(Listed::of)
        .filter(Listed::ofMessages)
        .map(Listed::list)
        .distinct()
        .toList();
  }

  /** Writes a list without objects into a message. */
  public void clear(MessageValue message) {
    write(List.of(), null, message);
  }

  /** Writes the current list of objects into a message. */
  public void fill(World world, SplittableRandom random, MessageValue message) {
    Road.Place eye = mounting.place(world.ego().front(), world.ego().shape());
    List<SeenObject> seen = new ArrayList<>();
    for (SeenObject each : around(world, eye)) {
      boolean hidden = hidden(world, eye, each.actor());
      boolean found = !(missed > 0.0) || random.nextDouble() >= missed;
      if (isInView(world, eye, each) && found && !hidden) {
        seen.add(each);
      }
    }
    write(seen, random, message);
  }

  private void write(List<SeenObject> seen, SplittableRandom random, MessageValue message) {
    int size = Math.min(seen.size(), capacity(message.type()));
    for (String list : messageLists()) {
      new Listed(list, "").make(message, size);
    }
    for (Column column : columns) {
      List<Object> values = new ArrayList<>();
      for (SeenObject each : seen) {
        values.add(value(column, each, random));
      }
      Listed.of(column.path()).write(message, values.subList(0, size));
    }
    for (Constant constant : constants) {
      Listed.of(constant.path()).write(message, Collections.nCopies(size, constant.value()));
    }
    if (count.isPresent()) {
      message.set(count.get(), size);
    }
  }

  /** Returns how many objects all lists can hold, and the field that counts them can tell. */
  private int capacity(MessageType type) {
    int capacity = count.map(path -> largest(type.resolve(path).type().orElseThrow())).orElse(ALL);
    for (String path : paths()) {
      if (count.filter(path::equals).isEmpty()) {
        capacity = Math.min(capacity, Listed.of(path).capacity(type));
      }
    }
    return capacity;
  }

  private static int largest(FieldType integer) {
    return switch (integer.kind()) {
      case INT8 -> Byte.MAX_VALUE;
      case BYTE, CHAR, UINT8 -> 0xFF;
      case INT16 -> Short.MAX_VALUE;
      case UINT16 -> 0xFFFF;
      default -> ALL;
    };
  }

  private static Object value(Column column, SeenObject object, SplittableRandom random) {
    if (column.property() == Property.CLASS) {
      ActorKind kind = object.actor().kind();
      return column.classes().isEmpty() ? kind.id() : column.classes().get(kind);
    }
    double exact = column.unit().ofCoherent(object.value(column.property()));
    double noise = column.noise() > 0.0 ? column.noise() * random.nextGaussian() : 0.0;
    return column.property() == Property.ID ? (Object) (long) exact : exact + noise;
  }

  /** Returns whether it looks ahead, with a view of no more than half a circle. */
  private boolean looksAlong() {
    return halfView <= Math.PI / 2 && mounting.direction() == 0.0;
  }

  /**
   * Returns whether an object is in the view: of a sensor that looks along the vehicle, if the
   * middle of its near end is; of others, which also see long sides, if a part of it is.
   */
  private boolean isInView(World world, Road.Place eye, SeenObject object) {
    if (looksAlong()) {
      return object.distance() <= range && Math.abs(object.azimuthOfEnd()) <= halfView;
    }
    Body body = object.actor().body(world.road(), World.seconds(world.now()));
    return object.range() <= range && Sight.of(body, eye).isWithin(halfView);
  }

  /**
   * Returns whether an actor is hidden; those beside the ego, flat or overhead may hide it, too.
   */
  private static boolean hidden(World world, Road.Place eye, Actor actor) {
    double seconds = World.seconds(world.now());
    List<Sight> others =
        world.actors().stream()
            .filter(each -> each != actor)
            .map(each -> Sight.of(each.body(world.road(), seconds), eye))
            .toList();
    return Sight.of(actor.body(world.road(), seconds), eye).isHidden(others, MOUNTED);
  }

  /** Returns all objects on the side of the view, the nearest first. */
  private List<SeenObject> around(World world, Road.Place eye) {
    List<SeenObject> seen = new ArrayList<>();
    int id = 0;
    for (Actor actor : world.allActors()) {
      id++;
      if (actor.obstructs(world.ego().shape()) && world.actors().contains(actor)) {
        SeenObject each = SeenObject.of(world, actor, eye, mounting.direction(), id);
        if (!looksAlong() || each.distance() > 0.0) {
          seen.add(each);
        }
      }
    }
    ToDoubleFunction<SeenObject> nearness = looksAlong() ? SeenObject::distance : SeenObject::range;
    seen.sort(Comparator.comparingDouble(nearness).thenComparingDouble(SeenObject::id));
    return seen;
  }
}
