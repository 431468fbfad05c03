package dev.eventchain.simulation.sensor;

import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * A list of the objects ahead, as from radars and cameras. Each field is a sequence with a number
 * for each object, the nearest first. Overhead structures and flat plates are no objects. Objects
 * wholly hidden behind others ({@link Sight}), as seen from the middle of the front bumper, are
 * left out; walls and posts hide nothing.
 *
 * @param range maximum distance, in m
 * @param halfView half of the field of view, in rad
 * @param missed fraction of the objects that a message randomly omits, 0 to 1
 */
public record ObjectSensor(double range, double halfView, double missed, List<Column> columns) {

  /** Height of the sensor over the road, in m: behind the bumper, as for radars. Assumed. */
  private static final double MOUNTED = 0.5;

  public ObjectSensor {
    columns = List.copyOf(columns);
  }

  /**
   * Quantities of a column, in the frame of the ego: x ahead from the front bumper, y to the left.
   */
  public enum Property {
    ID("1", "number of the object, the same in all messages"),
    DISTANCE("m", "from the front bumper ahead to its nearest point"),
    LATERAL("m", "its middle to the left of the ego's axis"),
    RELATIVE_SPEED("m/s", "along the ego's axis, negative if it comes nearer"),
    SPEED("m/s", "along the ego's axis, over ground"),
    LATERAL_SPEED("m/s", "across the ego's axis, over ground, to the left"),
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
   * A field of the message.
   *
   * @param unit the unit of the field
   * @param noise standard deviation, in the field's unit
   */
  public record Column(String path, Property property, Unit unit, double noise) {}

  /** An object in the frame of the ego, in coherent units. */
  private record Seen(
      Actor actor,
      double id,
      double distance,
      double lateral,
      double relative,
      double speed,
      double lateralSpeed) {

    double value(Property property) {
      return switch (property) {
        case ID -> id;
        case DISTANCE -> distance;
        case LATERAL -> lateral;
        case RELATIVE_SPEED -> relative;
        case SPEED -> speed;
        case LATERAL_SPEED -> lateralSpeed;
        case LENGTH -> actor.size().length();
        case WIDTH -> actor.size().width();
        case HEIGHT -> actor.size().top();
      };
    }
  }

  /** Writes the current list of objects into a message. */
  public void fill(World world, SplittableRandom random, MessageValue message) {
    List<Seen> seen = new ArrayList<>();
    for (Seen each : around(world)) {
      double azimuth = StrictMath.atan2(each.lateral(), Math.max(each.distance(), 0.1));
      boolean inView = each.distance() <= range && Math.abs(azimuth) <= halfView;
      boolean hidden = hidden(world, each.actor());
      boolean found = !(missed > 0.0) || random.nextDouble() >= missed;
      if (inView && found && !hidden) {
        seen.add(each);
      }
    }
    for (Column column : columns) {
      List<Object> values = new ArrayList<>();
      for (Seen each : seen) {
        double exact = column.unit().ofCoherent(each.value(column.property()));
        double noise = column.noise() > 0.0 ? column.noise() * random.nextGaussian() : 0.0;
        values.add(column.property() == Property.ID ? (Object) (long) exact : exact + noise);
      }
      message.set(column.path(), values);
    }
  }

  /**
   * Returns whether an actor is hidden; those beside the ego, flat or overhead may hide it, too.
   */
  private static boolean hidden(World world, Actor actor) {
    double seconds = World.seconds(world.now());
    Road.Place eye = world.ego().front();
    List<Sight> others =
        world.actors().stream()
            .filter(each -> each != actor)
            .map(each -> Sight.of(each.body(world.road(), seconds), eye))
            .toList();
    return Sight.of(actor.body(world.road(), seconds), eye).isHidden(others, MOUNTED);
  }

  /** Returns all objects ahead, the nearest first. */
  private static List<Seen> around(World world) {
    double seconds = World.seconds(world.now());
    Road.Place ego = world.ego().front();
    List<Seen> seen = new ArrayList<>();
    int id = 0;
    for (Actor actor : world.allActors()) {
      id++;
      if (actor.obstructs(world.ego().shape()) && world.actors().contains(actor)) {
        Seen each = seen(world, actor, ego, id, seconds);
        if (each.distance() > 0.0) {
          seen.add(each);
        }
      }
    }
    seen.sort(Comparator.comparingDouble(Seen::distance).thenComparingDouble(Seen::id));
    return seen;
  }

  private static Seen seen(World world, Actor actor, Road.Place ego, int id, double seconds) {
    Body body = actor.body(world.road(), seconds);
    double cos = StrictMath.cos(ego.heading());
    double sin = StrictMath.sin(ego.heading());
    double x = body.place().x() - ego.x();
    double y = body.place().y() - ego.y();
    double ahead = x * cos + y * sin - body.extent(ego.heading() - body.place().heading());
    double turned = world.road().heading(actor.along(seconds)) - ego.heading();
    double turnedCos = StrictMath.cos(turned);
    double turnedSin = StrictMath.sin(turned);
    double along = actor.speedAlong(seconds);
    double across = actor.speedAcross(seconds);
    double speed = along * turnedCos - across * turnedSin;
    return new Seen(
        actor,
        id,
        ahead,
        y * cos - x * sin,
        speed - world.ego().velocity(),
        speed,
        along * turnedSin + across * turnedCos);
  }
}
