package dev.eventchain.simulation.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.sensor.ObjectSensor.Column;
import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.SpeedProfile;
import dev.eventchain.simulation.world.World;
import java.lang.reflect.Array;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the lists of objects ahead. */
class ObjectSensorTest {

  private static final MessageType TYPE =
      MessageCatalog.of(List.of(Path.of("src/test/resources/benches/msg")))
          .find("demo_msgs/msg/ObjectList")
          .orElseThrow();

  private static Column column(String path, Property property, String unit, double noise) {
    return new Column(path, property, Unit.parse(unit).orElseThrow(), noise);
  }

  private static MessageValue seen(World world, double missed, double noise, long seed) {
    ObjectSensor sensor =
        new ObjectSensor(
            Mounting.FRONT,
            100,
            StrictMath.toRadians(30),
            missed,
            List.of(
                column("id", Property.ID, "1", 0),
                column("distance", Property.DISTANCE, "m", noise),
                column("lateral", Property.LATERAL, "m", 0),
                column("relative_speed", Property.RELATIVE_SPEED, "km/h", 0)),
            List.of(),
            Optional.empty());
    MessageValue message = MessageValue.of(TYPE);
    sensor.fill(world, new SplittableRandom(seed), message);
    return message;
  }

  private static List<Double> numbers(MessageValue message, String path) {
    List<Double> numbers = new ArrayList<>();
    Object array = message.get(path);
    for (int i = 0; i < Array.getLength(array); i++) {
      numbers.add(((Number) Array.get(array, i)).doubleValue());
    }
    return numbers;
  }

  private static World world(Actor... actors) {
    return new World(EgoVehicle.withSpeed(20), List.of(actors));
  }

  @Test
  void nearestComesFirstWithItsPlaceAndSpeed() {
    World world = world(Actor.passengerCar(60, 25, 0), Actor.passengerCar(30, 10, 3.5));
    MessageValue message = seen(world, 0, 0, 1);
    assertEquals(List.of(2.0, 1.0), numbers(message, "id"));
    assertEquals(30, numbers(message, "distance").get(0), 1e-5);
    assertEquals(60, numbers(message, "distance").get(1), 1e-5);
    assertEquals(List.of(3.5, 0.0), numbers(message, "lateral"));
    assertEquals(-36, numbers(message, "relative_speed").get(0), 1e-9);
    assertEquals(18, numbers(message, "relative_speed").get(1), 1e-9);
  }

  @Test
  void whatIsFarAsideBehindOrAboveIsNotSeen() {
    World world =
        world(
            Actor.passengerCar(101, 0, 0),
            Actor.passengerCar(5, 0, 5),
            Actor.passengerCar(-20, 0, 0),
            new Actor(
                "bridge",
                ActorKind.BRIDGE,
                ActorKind.BRIDGE.size(),
                40,
                0,
                new SpeedProfile(0, List.of()),
                new LateralProfile(0, List.of())));
    assertEquals(List.of(), numbers(seen(world, 0, 0, 1), "distance"));
  }

  @Test
  void whatIsHiddenIsMissingUntilItComesOut() {
    Actor comesOut =
        new Actor(
            "car",
            ActorKind.CAR,
            ActorKind.CAR.size(),
            60,
            0,
            new SpeedProfile(20, List.of()),
            new LateralProfile(0, List.of(new LateralProfile.Change(1, 3.5, 2))));
    World world =
        world(comesOut, Actor.passengerCar(30, 20, 0), TestActors.standing(ActorKind.LORRY, 95));
    assertEquals(List.of(2.0, 3.0), numbers(seen(world, 0, 0, 1), "id"));
    world.advanceTo(3_000_000_000L);
    assertEquals(List.of(2.0, 3.0, 1.0), numbers(seen(world, 0, 0, 1), "id"));
  }

  @Test
  void plateAndBridgeHideNothing() {
    World world =
        world(
            TestActors.standing(ActorKind.STEEL_PLATE, 10),
            TestActors.standing(ActorKind.BRIDGE, 20),
            TestActors.standing(ActorKind.CAR, 50));
    assertEquals(List.of(3.0), numbers(seen(world, 0, 0, 1), "id"));
  }

  @Test
  void noiseAndMissedObjectsAreAsMuchAsAskedForAndFollowTheSeed() {
    World world = world(Actor.passengerCar(50, 20, 0));
    int found = 0;
    double squares = 0;
    for (int seed = 0; seed < 2000; seed++) {
      List<Double> distances = numbers(seen(world, 0.3, 0.5, seed), "distance");
      assertEquals(distances, numbers(seen(world, 0.3, 0.5, seed), "distance"));
      found += distances.size();
      for (double each : distances) {
        squares += (each - 50) * (each - 50);
      }
    }
    assertEquals(1400, found, 100);
    assertEquals(0.5, Math.sqrt(squares / found), 0.04);
    assertTrue(found > 0);
  }
}
