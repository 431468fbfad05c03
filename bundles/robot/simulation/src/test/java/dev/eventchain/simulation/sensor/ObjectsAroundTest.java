package dev.eventchain.simulation.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.sensor.ObjectSensor.Column;
import dev.eventchain.simulation.sensor.ObjectSensor.Constant;
import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.SpeedProfile;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests lists of objects to the side, behind and all around, and their messages in arrays. */
class ObjectsAroundTest {

  private static final MessageType TYPE = type("demo_msgs/msg/Detections");

  /** Of the ego and of a car, in m. */
  private static final double LENGTH = 4.5;

  private static MessageType type(String name) {
    return MessageCatalog.of(List.of(Path.of("src/test/resources/benches/msg")))
        .find(name)
        .orElseThrow();
  }

  private static Column column(String field, Property property) {
    return new Column("detections[]." + field, property, property.unit(), 0);
  }

  private static List<MessageValue> seen(World world, Mounting mounting, double viewDegrees) {
    Map<ActorKind, Integer> classes = new EnumMap<>(ActorKind.class);
    for (ActorKind kind : ActorKind.values()) {
      classes.put(kind, kind == ActorKind.CAR ? 1 : kind == ActorKind.PEDESTRIAN ? 2 : 0);
    }
    ObjectSensor sensor =
        new ObjectSensor(
            mounting,
            100,
            StrictMath.toRadians(viewDegrees / 2),
            0,
            List.of(
                column("id", Property.ID),
                column("pose.position.x", Property.X),
                column("pose.position.y", Property.Y),
                column("pose.orientation.z", Property.ORIENTATION_Z),
                column("pose.orientation.w", Property.ORIENTATION_W),
                column("range", Property.RANGE),
                column("azimuth", Property.AZIMUTH),
                column("range_rate", Property.RANGE_RATE),
                column("label", Property.CLASS),
                new Column(
                    "detections[].classification",
                    Property.CLASS,
                    Unit.parse("1").orElseThrow(),
                    0,
                    classes),
                new Column("distances", Property.DISTANCE, Property.DISTANCE.unit(), 0)),
            List.of(new Constant("detections[].header.frame_id", "radar")),
            Optional.of("count"));
    MessageValue message = MessageValue.of(TYPE);
    sensor.clear(message);
    assertEquals(0.0, message.number("count"));
    sensor.fill(world, new SplittableRandom(1), message);
    List<MessageValue> found = new ArrayList<>();
    ((List<?>) message.get("detections")).forEach(each -> found.add((MessageValue) each));
    assertEquals(found.size(), message.number("count"));
    assertEquals(4, ((float[]) message.get("distances")).length);
    return found;
  }

  private static Mounting facing(double degrees) {
    return new Mounting(
        OptionalDouble.empty(), OptionalDouble.empty(), StrictMath.toRadians(degrees));
  }

  private static World world(Actor... actors) {
    return new World(EgoVehicle.withSpeed(20), List.of(actors));
  }

  @Test
  void sensorAtTheRearSeesWhatFollows() {
    // The front of the car is 30 m behind the rear of the ego.
    World world =
        world(
            TestActors.moving(ActorKind.CAR, -30 - 2 * LENGTH, 0, 25),
            Actor.passengerCar(20, 0, 0));
    List<MessageValue> seen = seen(world, facing(180), 60);
    assertEquals(1, seen.size());
    MessageValue car = seen.get(0);
    assertEquals(1, car.number("id"));
    assertEquals(30 + LENGTH / 2, car.number("pose.position.x"), 1e-6);
    assertEquals(0, car.number("pose.position.y"), 1e-6);
    assertEquals(30, car.number("range"), 1e-5);
    assertEquals(-5, car.number("range_rate"), 1e-5, "it comes nearer by 5 m/s");
    assertEquals(1, Math.abs(car.number("pose.orientation.z")), 1e-9, "it looks to the sensor");
    assertEquals(0, car.number("pose.orientation.w"), 1e-9);
    assertEquals("car", car.get("label"));
    assertEquals(1, car.number("classification"));
    assertEquals("radar", car.get("header.frame_id"));
  }

  @ParameterizedTest
  @CsvSource({"90, 5.0, 1", "-90, 5.0, 0", "90, -5.0, 0", "-90, -5.0, 1"})
  void sensorAtTheSideSeesItsSide(double direction, double across, int expected) {
    World world = world(TestActors.moving(ActorKind.PEDESTRIAN, -LENGTH / 2, across, 20));
    List<MessageValue> seen = seen(world, facing(direction), 90);
    assertEquals(expected, seen.size());
    for (MessageValue each : seen) {
      double halfWidth = 0.9;
      assertEquals(5.0 - halfWidth, each.number("pose.position.x"), 1e-6);
      assertEquals("pedestrian", each.get("label"));
      assertEquals(2, each.number("classification"));
    }
  }

  @Test
  void fullCircleSeesAllAroundTheNearestFirst() {
    Mounting middle = new Mounting(OptionalDouble.of(-LENGTH / 2), OptionalDouble.of(0), 0);
    World world =
        world(
            TestActors.moving(ActorKind.CAR, 40, 0, 20),
            TestActors.moving(ActorKind.CAR, -20 - LENGTH, 0, 20),
            TestActors.moving(ActorKind.MOTORCYCLE, -LENGTH / 2, 4, 20));
    List<MessageValue> seen = seen(world, middle, 360);
    assertEquals(List.of(3.0, 2.0, 1.0), seen.stream().map(each -> each.number("id")).toList());
    assertEquals(Math.PI, Math.abs(seen.get(1).number("azimuth")), 1e-6, "behind");
    assertEquals(0, seen.get(2).number("azimuth"), 1e-6, "ahead");
    assertEquals(0, seen.get(0).number("classification"), "another kind");
  }

  @Test
  void longVehicleBesideIsSeenThoughItsMiddleIsNot() {
    Actor lorry =
        new Actor(
            "lorry",
            ActorKind.LORRY,
            new Actor.Size(16, 2.5, 0, 4),
            -14,
            0,
            new SpeedProfile(20, List.of()),
            new LateralProfile(3.5, List.of()));
    assertEquals(1, seen(world(lorry), facing(90), 90).size());
    assertEquals(0, seen(world(lorry), facing(-90), 90).size());
  }

  @Test
  void distanceOfWhatIsBehindIsThatOfItsFront() {
    Mounting middle = new Mounting(OptionalDouble.of(0), OptionalDouble.of(0), 0);
    ObjectSensor sensor =
        new ObjectSensor(
            middle,
            100,
            Math.PI,
            0,
            List.of(
                new Column("distances", Property.DISTANCE, Property.DISTANCE.unit(), 0),
                new Column("labels", Property.CLASS, Property.CLASS.unit(), 0, Map.of())),
            List.of(),
            Optional.empty());
    MessageValue message = MessageValue.of(TYPE);
    World world =
        world(
            TestActors.moving(ActorKind.CAR, -30, 0, 20),
            TestActors.moving(ActorKind.CAR, 40, 0, 20));
    sensor.fill(world, new SplittableRandom(1), message);
    float[] distances = (float[]) message.get("distances");
    assertEquals(-30 + LENGTH, distances[0], 1e-4);
    assertEquals(40, distances[1], 1e-4);
    assertEquals(List.of("car", "car", ""), message.get("labels"));
  }

  @Test
  void boundedListHoldsTheNearest() {
    World world =
        world(
            TestActors.moving(ActorKind.CAR, 80, 3.5, 20),
            TestActors.moving(ActorKind.CAR, 60, -3.5, 20),
            TestActors.moving(ActorKind.CAR, 40, 3.5, 20),
            TestActors.moving(ActorKind.CAR, 20, 0, 20));
    List<MessageValue> seen = seen(world, Mounting.FRONT, 60);
    assertEquals(3, seen.size());
    assertEquals(List.of(4.0, 3.0, 2.0), seen.stream().map(each -> each.number("id")).toList());
  }

  @Test
  void listEndsWhereItsNumberEnds() {
    Column distance = new Column("distance", Property.DISTANCE, Property.DISTANCE.unit(), 0);
    ObjectSensor sensor =
        new ObjectSensor(
            Mounting.FRONT, 500, Math.PI, 0, List.of(distance), List.of(), Optional.of("count"));
    MessageValue message = MessageValue.of(type("demo_msgs/msg/Pedestrians"));
    Actor[] crowd =
        IntStream.range(0, 300)
            .mapToObj(i -> TestActors.moving(ActorKind.PEDESTRIAN, 30, i - 150, 0))
            .toArray(Actor[]::new);
    sensor.fill(world(crowd), new SplittableRandom(1), message);
    assertEquals(255, message.number("count"));
    assertEquals(255, ((float[]) message.get("distance")).length);
  }
}
