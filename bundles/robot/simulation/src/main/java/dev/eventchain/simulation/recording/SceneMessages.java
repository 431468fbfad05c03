package dev.eventchain.simulation.recording;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.recording.ScenePoses.Named;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import java.util.ArrayList;
import java.util.List;

/** Poses and bodies as messages, for RViz and Foxglove. */
final class SceneMessages {

  /** The frame of the road. */
  static final String MAP = "map";

  /** The frame of the ego, as CARLA names it. */
  static final String EGO = "ego_vehicle";

  private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";
  private static final String BODIES = "visualization_msgs/msg/MarkerArray";
  private static final int CUBE = 1;

  /** Lifetime of a body on display after its last message, in ns. */
  private static final long LIFETIME = 200_000_000L;

  private static final long SECOND = 1_000_000_000L;

  private final MessageCatalog catalog = MessageCatalog.of(List.of());
  private final MessageType transforms = catalog.find(TRANSFORMS).orElseThrow();
  private final MessageType bodies = catalog.find(BODIES).orElseThrow();
  private final String lidarFrame;

  /**
   * Creates the messages of scenes.
   *
   * @param lidarFrame the frame of the lidar's messages; empty if there are none
   */
  SceneMessages(String lidarFrame) {
    this.lidarFrame = lidarFrame;
  }

  /** Returns the definitions of the types, which are independent of the project. */
  MessageCatalog catalog() {
    return catalog;
  }

  MessageType transforms() {
    return transforms;
  }

  MessageType bodies() {
    return bodies;
  }

  /**
   * Returns the transforms: those of the ego and the others in the map, the lidar's in the ego's
   * frame.
   */
  byte[] transforms(ScenePoses scene, long time) {
    MessageType type = elementOf(transforms, "transforms");
    List<MessageValue> all = new ArrayList<>();
    all.add(transform(type, time, MAP, EGO, scene.ego()));
    if (!lidarFrame.isEmpty() && !lidarFrame.equals(MAP) && !lidarFrame.equals(EGO)) {
      Road.Place behind = new Road.Place(-scene.lidarBehind(), 0.0, 0.0);
      MessageValue lidar = transform(type, time, EGO, lidarFrame, behind);
      all.add(lidar.set("transform.translation.z", scene.lidarAbove()));
    }
    for (Named actor : scene.actors()) {
      all.add(transform(type, time, MAP, actor.name(), actor.body().place()));
    }
    return CdrCodec.encode(MessageValue.of(transforms).set("transforms", all));
  }

  private static MessageValue transform(
      MessageType type, long time, String parent, String child, Road.Place place) {
    MessageValue message = stamped(type, time, parent).set("child_frame_id", child);
    message.set("transform.translation.x", place.x()).set("transform.translation.y", place.y());
    return turned(message, "transform.rotation", place.heading());
  }

  /** Returns a box for each body. */
  byte[] bodies(ScenePoses scene, long time) {
    MessageType type = elementOf(bodies, "markers");
    List<MessageValue> all = new ArrayList<>();
    all.add(body(type, time, scene.egoBody()).set("color.b", 0.9));
    for (Named actor : scene.actors()) {
      all.add(body(type, time, actor).set("color.r", 0.9));
    }
    return CdrCodec.encode(MessageValue.of(bodies).set("markers", all));
  }

  private static MessageValue body(MessageType type, long time, Named actor) {
    MessageValue message = stamped(type, time, MAP).set("ns", actor.name());
    message.set("lifetime.nanosec", LIFETIME);
    message.set("type", CUBE).set("color.g", 0.3).set("color.a", 0.8);
    Body body = actor.body();
    message.set("pose.position.x", body.place().x()).set("pose.position.y", body.place().y());
    message.set("pose.position.z", (body.bottom() + body.top()) / 2);
    message.set("scale.x", body.length()).set("scale.y", body.width());
    message.set("scale.z", body.top() - body.bottom());
    return turned(message, "pose.orientation", body.place().heading());
  }

  private static MessageValue stamped(MessageType type, long time, String frame) {
    MessageValue message = MessageValue.of(type).set("header.frame_id", frame);
    message.set("header.stamp.sec", (int) (time / SECOND));
    return message.set("header.stamp.nanosec", time % SECOND);
  }

  private static MessageValue turned(MessageValue message, String field, double yaw) {
    message.set(field + ".z", StrictMath.sin(yaw / 2));
    return message.set(field + ".w", StrictMath.cos(yaw / 2));
  }

  private static MessageType elementOf(MessageType type, String field) {
    return type.resolve(field).type().flatMap(FieldType::message).orElseThrow();
  }
}
