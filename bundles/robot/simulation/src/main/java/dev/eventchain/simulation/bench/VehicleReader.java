package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.world.Chassis;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LidarSettings;
import dev.eventchain.simulation.world.Shape;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.OptionalDouble;

/** Reads the properties of the vehicle, of a bench or of a scenario. */
public final class VehicleReader {

  /** The key of how long a speed is constant that changes in steps. */
  public static final String SPEED_STEP = "speed_step_s";

  /** The key of how fast a vehicle turns that turns on the spot. */
  public static final String YAW_RATE = "maximal_yaw_rate_radps";

  private static final String COMMAND_TIMEOUT = "command_timeout_s";

  /** The keys that say how a vehicle follows a commanded speed. */
  static final List<String> FOLLOWING =
      List.of("maximal_acceleration_mps2", "maximal_deceleration_mps2", COMMAND_TIMEOUT);

  private static final double SHORTEST_STEP = World.seconds(World.TRACE_STEP);

  private VehicleReader() {}

  /**
   * Reads a vehicle.
   *
   * @param usual what holds where the section says nothing
   * @param speed at the start, in m/s
   * @param range the rule of a size that is not possible
   */
  public static EgoVehicle read(ObjectReader section, EgoVehicle usual, double speed, Rule range) {
    EgoVehicle vehicle =
        new EgoVehicle(
            speed,
            number(section, "brake_delay_s", usual.brakeDelay(), 0, 5),
            number(section, "brake_build_up_s", usual.brakeBuildUp(), 0, 5),
            number(section, "maximal_deceleration_mps2", usual.maximalDeceleration(), 0.1, 20),
            number(section, "coasting_deceleration_mps2", usual.coastingDeceleration(), 0, 5),
            number(section, "maximal_acceleration_mps2", usual.maximalAcceleration(), 0, 20),
            lidar(section, usual.lidar()),
            chassis(section, usual.chassis()),
            shape(section, usual.shape()),
            speedStep(section, usual.speedStep(), range),
            number(section, COMMAND_TIMEOUT, usual.commandTimeout(), 0, 10));
    double axles = vehicle.chassis().wheelbase() + vehicle.shape().frontOverhang();
    if (axles > vehicle.shape().length()) {
      String key = section.has("length_m") ? "length_m" : "wheelbase_m";
      section.find(
          range, "Its wheelbase and front overhang are longer than it is.", section.at(key));
    }
    return vehicle;
  }

  private static double speedStep(ObjectReader section, double usual, Rule range) {
    double step = number(section, SPEED_STEP, usual, 0, 0.5);
    if (step > 0.0 && step < SHORTEST_STEP) {
      String message = "A step lasts 0.01 s at least, and 0 means that the speed has none.";
      section.find(range, message, section.at(SPEED_STEP));
      return usual;
    }
    return step;
  }

  private static LidarSettings lidar(ObjectReader section, LidarSettings usual) {
    OptionalDouble dropout = section.number("lidar_dropout_percent", NumberRange.of(0, 100));
    return new LidarSettings(
        number(section, "lidar_behind_bumper_m", usual.behindBumper(), 0, 10),
        number(section, "lidar_above_road_m", usual.aboveRoad(), 0.5, 5),
        number(section, "lidar_noise_m", usual.noise(), 0, 1),
        dropout.isPresent() ? dropout.getAsDouble() / 100 : usual.dropout(),
        number(section, "lidar_azimuth_step_deg", usual.azimuthStep(), 0.1, 5));
  }

  private static Chassis chassis(ObjectReader section, Chassis usual) {
    return new Chassis(
        number(section, "wheelbase_m", usual.wheelbase(), 0.1, 10),
        radians(section, "maximal_steering_angle_deg", usual.maximalSteeringAngle(), 1, 60),
        number(section, "hand_brake_deceleration_mps2", usual.handBrakeDeceleration(), 0, 10),
        number(section, "drag_per_m", usual.drag(), 0, 0.01),
        usual.offset(),
        usual.heading(),
        number(section, YAW_RATE, usual.maximalYawRate(), 0, 10));
  }

  private static Shape shape(ObjectReader section, Shape usual) {
    return new Shape(
        number(section, "length_m", usual.length(), 1, 20),
        number(section, "width_m", usual.width(), 0.5, 3),
        number(section, "height_m", usual.height(), 0.5, 5),
        number(section, "front_overhang_m", usual.frontOverhang(), 0, 5));
  }

  /** Reads an angle in degrees; returns it in rad. */
  public static double radians(
      ObjectReader section, String key, double absent, double least, double most) {
    OptionalDouble degrees = section.number(key, NumberRange.of(least, most));
    return degrees.isPresent() ? StrictMath.toRadians(degrees.getAsDouble()) : absent;
  }

  /** Reads a number within bounds. */
  public static double number(
      ObjectReader section, String key, double absent, double least, double most) {
    return section.number(key, NumberRange.of(least, most)).orElse(absent);
  }
}
