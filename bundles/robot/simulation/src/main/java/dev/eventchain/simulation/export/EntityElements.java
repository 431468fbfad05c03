package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Shape;

/** Entities with their boxes. What a scenario does not say of a vehicle is assumed. */
final class EntityElements {

  /** Beginning of the names of all properties. */
  static final String PREFIX = "eventchain.";

  private static final double WHEEL = 0.6;
  private static final double MASS = 1500.0;
  private static final double WALKER = 80.0;

  /** More than any script asks for, so that none is limited. */
  private static final double FASTEST = 70.0;

  private static final double HARDEST = 20.0;

  private EntityElements() {}

  /** Returns the vehicle under test, which some software controls. */
  static Markup ego(EgoVehicle ego, String software) {
    Shape shape = ego.shape();
    double middle = ego.axleToBumper() - shape.length() / 2;
    Actor.Size size = new Actor.Size(shape.length(), shape.width(), 0.0, shape.height());
    double steering = ego.chassis().maximalSteeringAngle();
    Markup performance = performance(ego.maximalAcceleration(), ego.maximalDeceleration());
    Markup vehicle = vehicle("car", size, middle, performance, steering, ego.chassis().wheelbase());
    Markup properties =
        new Markup("Properties")
            .add(property("software", software), property("active", "from its first demand on"));
    Markup controller =
        new Markup("Controller").with("name", "software under test").add(properties);
    return new Markup("ScenarioObject")
        .with("name", EntityNames.EGO)
        .add(vehicle, new Markup("ObjectController").add(controller));
  }

  /** Returns an actor. */
  static Markup actor(Actor actor, String entity) {
    Markup object = new Markup("ScenarioObject").with("name", entity);
    ActorKind kind = actor.kind();
    double reach = Mover.reach(actor);
    if (Mover.isVehicle(kind)) {
      Markup performance = performance(HARDEST, HARDEST);
      return object.add(vehicle(category(kind), actor.size(), reach, performance, 0.5, 2 * reach));
    }
    if (kind == ActorKind.PEDESTRIAN) {
      return object.add(
          new Markup("Pedestrian")
              .with("name", kind.id())
              .with("mass", WALKER)
              .with("pedestrianCategory", "pedestrian")
              .add(box(actor.size(), 0.0), kind(kind)));
    }
    return object.add(
        new Markup("MiscObject")
            .with("name", kind.id())
            .with("mass", MASS)
            .with("miscObjectCategory", category(kind))
            .add(box(actor.size(), 0.0), kind(kind)));
  }

  private static Markup kind(ActorKind kind) {
    return new Markup("Properties").add(property("kind", kind.id()));
  }

  /** Returns a property of ours. */
  static Markup property(String name, String value) {
    return new Markup("Property").with("name", PREFIX + name).with("value", text(value));
  }

  /** Returns a text that is not read as the name of a parameter. */
  static String text(String value) {
    return value.startsWith("$") ? "\\" + value : value;
  }

  private static String category(ActorKind kind) {
    return switch (kind) {
      case CAR, PARKED_CAR -> "car";
      case LORRY -> "truck";
      case MOTORCYCLE -> "motorbike";
      case BICYCLE -> "bicycle";
      case OVERHEAD_SIGN -> "gantry";
      case GUARD_RAIL -> "railing";
      case STEEL_PLATE -> "patch";
      case BRIDGE -> "building";
      case OBSTACLE -> "obstacle";
      case PEDESTRIAN -> "none";
    };
  }

  private static Markup performance(double acceleration, double deceleration) {
    return new Markup("Performance")
        .with("maxSpeed", FASTEST)
        .with("maxAcceleration", acceleration)
        .with("maxDeceleration", deceleration);
  }

  private static Markup vehicle(
      String category,
      Actor.Size size,
      double middle,
      Markup performance,
      double steering,
      double wheelbase) {
    return new Markup("Vehicle")
        .with("name", category)
        .with("vehicleCategory", category)
        .add(
            box(size, middle),
            performance,
            new Markup("Axles")
                .add(
                    axle("FrontAxle", steering, wheelbase, size),
                    axle("RearAxle", 0.0, 0.0, size)));
  }

  private static Markup axle(String name, double steering, double x, Actor.Size size) {
    return new Markup(name)
        .with("maxSteering", steering)
        .with("wheelDiameter", WHEEL)
        .with("trackWidth", size.width())
        .with("positionX", x)
        .with("positionZ", WHEEL / 2);
  }

  private static Markup box(Actor.Size size, double middle) {
    return new Markup("BoundingBox")
        .add(
            new Markup("Center")
                .with("x", middle)
                .with("y", 0.0)
                .with("z", (size.bottom() + size.top()) / 2),
            new Markup("Dimensions")
                .with("length", size.length())
                .with("width", size.width())
                .with("height", size.top() - size.bottom()));
  }
}
