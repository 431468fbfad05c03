package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What the vehicle offers to its software and takes from it: topics and message types of the CARLA
 * ROS bridge for a vehicle named {@code ego_vehicle}, and the clock. The definitions are those that
 * the nodes use.
 */
final class CarlaBridge {

  /** A topic and its message type. */
  record Topic(String name, String type) {}

  /** The points of the roof lidar. */
  static final Topic LIDAR = new Topic("/carla/ego_vehicle/lidar", "sensor_msgs/msg/PointCloud2");

  /** The command that the vehicle follows. */
  static final Topic CONTROL =
      new Topic("/carla/ego_vehicle/vehicle_control_cmd", "carla_msgs/msg/CarlaEgoVehicleControl");

  private static final Topic STATUS =
      new Topic("/carla/ego_vehicle/vehicle_status", "carla_msgs/msg/CarlaEgoVehicleStatus");
  private static final Topic ODOMETRY =
      new Topic("/carla/ego_vehicle/odometry", "nav_msgs/msg/Odometry");
  private static final Topic SPEEDOMETER =
      new Topic("/carla/ego_vehicle/speedometer", "std_msgs/msg/Float32");
  private static final Topic CLOCK = new Topic("/clock", "rosgraph_msgs/msg/Clock");

  private static final String FRAME = "ego_vehicle";
  private static final int FLOAT32 = 7;
  private static final long SECOND = 1_000_000_000L;

  private final MessageCatalog catalog;
  private final List<Topic> published;
  private final List<MessageValue> messages;
  private final MessageType control;

  /**
   * Offers what is asked for, so that nothing is computed in vain; the clock is always offered.
   *
   * @param catalog where the message types are defined
   * @param wanted names of the topics that the software reads
   * @throws DiagnosticException (INPUT) {@code message.unknown} or {@code message.field.missing}: a
   *     definition is missing or is not the one of the CARLA ROS bridge
   */
  CarlaBridge(MessageCatalog catalog, Collection<String> wanted) {
    this.catalog = catalog;
    this.published =
        Stream.of(CLOCK, LIDAR, STATUS, ODOMETRY, SPEEDOMETER)
            .filter(topic -> topic.equals(CLOCK) || wanted.contains(topic.name()))
            .toList();
    this.messages = published.stream().map(this::message).toList();
    this.control = type(CONTROL);
    checked(CONTROL, () -> command(MessageValue.of(control)));
  }

  private MessageType type(Topic topic) {
    return catalog
        .find(topic.type())
        .orElseThrow(
            () ->
                refused(
                    "message.unknown",
                    "The vehicle's topic " + topic.name() + " needs " + topic.type() + ".",
                    topic));
  }

  private MessageValue message(Topic topic) {
    MessageValue message = MessageValue.of(type(topic));
    checked(topic, () -> constants(topic, message));
    return message;
  }

  /** Sets what never changes. */
  private void constants(Topic topic, MessageValue message) {
    if (topic.equals(LIDAR)) {
      message.set("header.frame_id", FRAME + "/lidar");
      message.set("height", 1L);
      message.set("fields", pointFields());
      message.set("point_step", (long) Lidar.POINT_STEP);
      message.set("is_dense", true);
    } else if (topic.equals(STATUS)) {
      message.set("header.frame_id", FRAME);
      message.set("orientation.w", 1.0);
      message.set("control.gear", 1);
    } else if (topic.equals(ODOMETRY)) {
      message.set("header.frame_id", "map");
      message.set("child_frame_id", FRAME);
      message.set("pose.pose.orientation.w", 1.0);
    }
  }

  private List<MessageValue> pointFields() {
    MessageType type = type(new Topic(LIDAR.name(), "sensor_msgs/msg/PointField"));
    List<MessageValue> fields = new ArrayList<>();
    for (String name : List.of("x", "y", "z", "intensity")) {
      MessageValue field = MessageValue.of(type);
      field.set("name", name);
      field.set("offset", (long) fields.size() * Float.BYTES);
      field.set("datatype", FLOAT32);
      field.set("count", 1L);
      fields.add(field);
    }
    return fields;
  }

  /** The topics it publishes; the index of a message's topic is the position here. */
  List<Topic> published() {
    return published;
  }

  /** What the sensors see at this moment: one message on each topic. */
  List<LockstepChannel.Inbound> sense(World world, Lidar lidar) {
    List<LockstepChannel.Inbound> sensed = new ArrayList<>();
    for (int i = 0; i < published.size(); i++) {
      Topic topic = published.get(i);
      MessageValue message = messages.get(i);
      checked(topic, () -> update(topic, message, world, lidar));
      sensed.add(new LockstepChannel.Inbound(i, ByteBuffer.wrap(CdrCodec.encode(message))));
    }
    return sensed;
  }

  private static void update(Topic topic, MessageValue message, World world, Lidar lidar) {
    if (topic.equals(LIDAR)) {
      byte[] points = lidar.scan(RoadScene.boxes(world));
      stamp(message, "header.stamp", world.now());
      message.set("width", (long) points.length / Lidar.POINT_STEP);
      message.set("row_step", (long) points.length);
      message.set("data", points);
    } else if (topic.equals(STATUS)) {
      stamp(message, "header.stamp", world.now());
      stamp(message, "control.header.stamp", world.now());
      message.set("velocity", (float) world.egoSpeed());
      message.set("acceleration.linear.x", -world.egoDeceleration());
      message.set("control.throttle", (float) world.lastCommand().throttle());
      message.set("control.brake", (float) world.lastCommand().brake());
    } else if (topic.equals(ODOMETRY)) {
      stamp(message, "header.stamp", world.now());
      message.set("pose.pose.position.x", world.egoPosition());
      message.set("twist.twist.linear.x", world.egoSpeed());
    } else if (topic.equals(SPEEDOMETER)) {
      message.set("data", (float) world.egoSpeed());
    } else {
      stamp(message, "clock", world.now());
    }
  }

  private static void stamp(MessageValue message, String field, long now) {
    message.set(field + ".sec", (int) (now / SECOND));
    message.set(field + ".nanosec", now % SECOND);
  }

  /** What a control message asks for. */
  VehicleCommand command(ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.duplicate().get(bytes);
    return command(CdrCodec.decode(control, bytes));
  }

  /** The simulated vehicle has pedals only: it keeps its lane and drives forwards. */
  private static VehicleCommand command(MessageValue message) {
    double throttle = message.number("throttle");
    double steer = message.number("steer");
    String ignored = "";
    if (!(throttle >= 0.0 && throttle <= 1.0)) {
      ignored = "throttle " + throttle;
    } else if (steer != 0.0) {
      ignored = "steer " + steer;
    } else if (Boolean.TRUE.equals(message.get("hand_brake"))) {
      ignored = "hand_brake";
    } else if (Boolean.TRUE.equals(message.get("reverse"))) {
      ignored = "reverse";
    } else if (Boolean.TRUE.equals(message.get("manual_gear_shift"))) {
      ignored = "manual_gear_shift";
    }
    return new VehicleCommand(throttle, message.number("brake"), ignored);
  }

  private void checked(Topic topic, Runnable access) {
    try {
      access.run();
    } catch (IllegalArgumentException e) {
      throw refused(
          "message.field.missing",
          "The vehicle's topic "
              + topic.name()
              + " needs "
              + topic.type()
              + " as CARLA defines it: "
              + e.getMessage(),
          topic);
    }
  }

  /** The place is the file that defines the type, or should. */
  private DiagnosticException refused(String id, String message, Topic topic) {
    List<Path> files =
        catalog.folders().stream().map(folder -> folder.resolve(topic.type() + ".msg")).toList();
    Optional<Path> file =
        files.stream()
            .filter(Files::isRegularFile)
            .findFirst()
            .or(() -> files.stream().findFirst());
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error(id, message, file.map(SourceLocation::of).orElse(SourceLocation.NONE))
            .withHint("Put the definition into software-base/msg/PACKAGE/msg/NAME.msg."));
  }
}
