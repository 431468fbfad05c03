package dev.eventchain.simulation;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Collection;
import java.util.List;
import java.util.stream.Stream;

/**
 * What the vehicle offers to its software and takes from it: topics and message types of the CARLA
 * ROS bridge for a vehicle named {@code ego_vehicle}, and the clock.
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

  /** Place of the brake in a control message whose frame id is empty. */
  private static final int ENCAPSULATION = 4;

  private final List<Topic> published;

  /**
   * Offers what is asked for, so that nothing is computed in vain; the clock is always offered.
   *
   * @param wanted names of the topics that the software reads
   */
  CarlaBridge(Collection<String> wanted) {
    published =
        Stream.of(CLOCK, LIDAR, STATUS, ODOMETRY, SPEEDOMETER)
            .filter(topic -> topic.equals(CLOCK) || wanted.contains(topic.name()))
            .toList();
  }

  /** The topics it publishes; the index of a message's topic is the position here. */
  List<Topic> published() {
    return published;
  }

  /** What the sensors see at this moment: one message on each topic. */
  List<LockstepChannel.Inbound> sense(World world, Lidar lidar) {
    return Stream.iterate(0, index -> index < published.size(), index -> index + 1)
        .map(
            index ->
                new LockstepChannel.Inbound(index, message(published.get(index), world, lidar)))
        .toList();
  }

  private static ByteBuffer message(Topic topic, World world, Lidar lidar) {
    if (topic.equals(LIDAR)) {
      return pointCloud(world.now(), lidar.scan(RoadScene.boxes(world)));
    } else if (topic.equals(STATUS)) {
      return status(world);
    } else if (topic.equals(ODOMETRY)) {
      return odometry(world);
    } else if (topic.equals(SPEEDOMETER)) {
      return new CdrWriter(8).float32(world.egoSpeed()).finish();
    }
    return new CdrWriter(8).time(world.now()).finish();
  }

  private static ByteBuffer pointCloud(long now, byte[] points) {
    CdrWriter cdr = new CdrWriter(points.length + 256);
    int width = points.length / Lidar.POINT_STEP;
    cdr.time(now).string(FRAME + "/lidar").int32(1).int32(width);
    String[] fields = {"x", "y", "z", "intensity"};
    cdr.int32(fields.length);
    for (int i = 0; i < fields.length; i++) {
      cdr.string(fields[i]).int32(i * Float.BYTES).uint8(FLOAT32).int32(1);
    }
    cdr.bool(false).int32(Lidar.POINT_STEP).int32(points.length).bytes(points).bool(true);
    return cdr.finish();
  }

  private static ByteBuffer status(World world) {
    CdrWriter cdr = new CdrWriter(256);
    cdr.time(world.now()).string(FRAME).float32(world.egoSpeed());
    cdr.float64(-world.egoDeceleration(), 0, 0, 0, 0, 0);
    cdr.float64(0, 0, 0, 1);
    cdr.time(world.now()).string("").float32(0).float32(0).float32(world.pedal());
    cdr.bool(false).bool(false).int32(1).bool(false);
    return cdr.finish();
  }

  private static ByteBuffer odometry(World world) {
    CdrWriter cdr = new CdrWriter(1024);
    cdr.time(world.now()).string("map").string(FRAME);
    cdr.float64(world.egoPosition(), 0, 0).float64(0, 0, 0, 1).float64(new double[36]);
    cdr.float64(world.egoSpeed(), 0, 0, 0, 0, 0).float64(new double[36]);
    return cdr.finish();
  }

  /** The brake of a control message. */
  static double brake(ByteBuffer message) {
    ByteBuffer cdr = message.duplicate().order(ByteOrder.LITTLE_ENDIAN);
    int frameLength = cdr.getInt(ENCAPSULATION + 8);
    int throttle = ENCAPSULATION + ((12 + frameLength + 3) & ~3);
    return cdr.getFloat(throttle + 8);
  }
}
