package dev.eventchain.simulation.bench;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Sources of the fields of standard messages about the state of the vehicle itself, whose units and
 * axes REP 103 and REP 145 give: odometry, inertial measurements, satellite navigation. On the
 * simulated road nothing rises, tilts or slides.
 */
final class StandardState {

  /** Words in names of topics about others. */
  private static final Pattern OTHERS =
      Pattern.compile("lead|target|object|other|front|rear|npc|leader|goal");

  private static final Map<String, Map<String, String>> SOURCES =
      Map.of(
          "nav_msgs/msg/Odometry", odometry(),
          "sensor_msgs/msg/Imu", imu(),
          "sensor_msgs/msg/NavSatFix",
              Map.of(
                  "latitude", "{value: ego.latitude, unit: deg}",
                  "longitude", "{value: ego.longitude, unit: deg}"));

  private StandardState() {}

  /** Returns the source of a field as a bench has it; empty if none is known. */
  static Optional<String> source(Signal signal, String field) {
    String type = RosNames.fullMessageType(signal.messageType());
    return OTHERS.matcher(signal.topic().toLowerCase(Locale.ROOT)).find()
        ? Optional.empty()
        : Optional.ofNullable(SOURCES.getOrDefault(type, Map.of()).get(field));
  }

  private static Map<String, String> odometry() {
    Map<String, String> fields = new HashMap<>();
    fields.put("pose.pose.position.x", "{value: ego.x, unit: m}");
    fields.put("pose.pose.position.y", "{value: ego.y, unit: m}");
    fields.put("pose.pose.position.z", "0");
    fields.putAll(orientation("pose.pose.orientation."));
    fields.put("twist.twist.linear.x", "{value: ego.speed, unit: m/s}");
    fields.put("twist.twist.linear.y", "0");
    fields.put("twist.twist.linear.z", "0");
    fields.put("twist.twist.angular.x", "0");
    fields.put("twist.twist.angular.y", "0");
    fields.put("twist.twist.angular.z", "{value: ego.yaw_rate, unit: rad/s}");
    return fields;
  }

  private static Map<String, String> imu() {
    Map<String, String> fields = new HashMap<>(orientation("orientation."));
    fields.put("angular_velocity.x", "0");
    fields.put("angular_velocity.y", "0");
    fields.put("angular_velocity.z", "{value: ego.yaw_rate, unit: rad/s}");
    fields.put("linear_acceleration.x", "{value: ego.acceleration, unit: m/s2}");
    fields.put("linear_acceleration.y", "{value: ego.acceleration.left, unit: m/s2}");
    fields.put("linear_acceleration.z", "9.81"); // it feels gravity
    return fields;
  }

  private static Map<String, String> orientation(String prefix) {
    return Map.of(
        prefix + "x", "0",
        prefix + "y", "0",
        prefix + "z", "ego.orientation.z",
        prefix + "w", "ego.orientation.w");
  }
}
