package dev.eventchain.simulation;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;

/**
 * A roof lidar that looks ahead: rings of rays, each of which returns the nearest of road, walls
 * and boxes with some noise along the ray, or nothing. Directions are computed once, with
 * StrictMath, so that every machine sees the same points.
 */
final class Lidar {

  /** Length of one point in bytes: x, y, z and intensity as float32. */
  static final int POINT_STEP = 16;

  /** What PointField calls a float32. */
  private static final int FLOAT32 = 7;

  /** Longest range, in m. */
  static final double RANGE = 100.0;

  /** Elevation of the rings, in degrees; dense where vehicles far ahead appear. */
  private static final double[] ELEVATIONS = {
    -0.3, -0.7, -1.0, -1.15, -1.3, -1.45, -1.6, -2.0, -2.6, -3.4, -4.6, -6.5, -9.5, -14.0, -20.0,
    -27.0
  };

  private static final double HALF_VIEW = 60.0;
  private static final double STEP = 0.5;
  private static final int AZIMUTHS = (int) (2 * HALF_VIEW / STEP) + 1;
  private static final int RAYS = ELEVATIONS.length * AZIMUTHS;
  private static final float ROAD_INTENSITY = 0.2f;
  private static final float WALL_INTENSITY = 0.4f;

  private static final VarHandle FLOAT =
      MethodHandles.byteArrayViewVarHandle(float[].class, ByteOrder.LITTLE_ENDIAN);

  /** Standard normal numbers; a scan takes a piece of them from a random place. */
  private static final float[] NOISE = noise();

  private static final double[] DIRECTION_X = new double[RAYS];
  private static final double[] DIRECTION_Y = new double[RAYS];
  private static final double[] DIRECTION_Z = new double[RAYS];

  static {
    for (int ray = 0; ray < RAYS; ray++) {
      double elevation = StrictMath.toRadians(ELEVATIONS[ray / AZIMUTHS]);
      double azimuth = StrictMath.toRadians((ray % AZIMUTHS) * STEP - HALF_VIEW);
      DIRECTION_X[ray] = StrictMath.cos(elevation) * StrictMath.cos(azimuth);
      DIRECTION_Y[ray] = StrictMath.cos(elevation) * StrictMath.sin(azimuth);
      DIRECTION_Z[ray] = StrictMath.sin(elevation);
    }
  }

  private final double behindBumper;
  private final double aboveRoad;
  private final float noise;
  private final SplittableRandom random;
  private final float[] backgroundRange = new float[RAYS];
  private final float[] backgroundIntensity = new float[RAYS];
  private final float[] range = new float[RAYS];
  private final float[] intensity = new float[RAYS];
  private final byte[] points = new byte[RAYS * POINT_STEP];

  Lidar(EgoVehicle vehicle, long seed) {
    this.behindBumper = vehicle.lidarBehindBumper();
    this.aboveRoad = vehicle.lidarAboveRoad();
    this.noise = (float) vehicle.lidarNoise();
    this.random = new SplittableRandom(seed);
    for (int ray = 0; ray < RAYS; ray++) {
      background(
          ray,
          RoadScene.WALL_DISTANCE / Math.abs(DIRECTION_Y[ray]),
          backgroundRange,
          backgroundIntensity);
    }
  }

  private static float[] noise() {
    Random gaussian = new Random(1);
    float[] values = new float[1 << 14];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) gaussian.nextGaussian();
    }
    return values;
  }

  /** Road and walls look the same from every place in the middle of a straight lane. */
  private void background(int ray, double wall, float[] ranges, float[] intensities) {
    double road = DIRECTION_Z[ray] < 0.0 ? aboveRoad / -DIRECTION_Z[ray] : Double.POSITIVE_INFINITY;
    double wallHeight = aboveRoad + wall * DIRECTION_Z[ray];
    boolean hitsWall = wall < road && wallHeight <= RoadScene.WALL_HEIGHT;
    ranges[ray] = (float) (hitsWall ? wall : road);
    intensities[ray] = hitsWall ? WALL_INTENSITY : ROAD_INTENSITY;
  }

  /** Sets what never changes in the messages of scans. */
  static void describe(MessageValue message) {
    message.set("height", 1L);
    message.set("fields", pointFields(message.type()));
    message.set("point_step", (long) POINT_STEP);
    message.set("is_dense", true);
  }

  private static List<MessageValue> pointFields(MessageType cloud) {
    MessageType type = cloud.resolve("fields").type().flatMap(FieldType::message).orElseThrow();
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

  /** One scan into a message, but for its header. */
  void scan(List<Box> boxes, Trace.Pose pose, MessageValue message) {
    byte[] scanned = scan(boxes, pose);
    message.set("width", (long) scanned.length / POINT_STEP);
    message.set("row_step", (long) scanned.length);
    message.set("data", scanned);
  }

  /**
   * One scan, as the data of a PointCloud2 in the lidar's frame (x forward, y left, z up).
   *
   * @param boxes seen from the front bumper of an ego in the middle of the lane
   * @param pose how the ego stands in the lane
   * @return {@link #POINT_STEP} bytes for each ray that returned
   */
  byte[] scan(List<Box> boxes, Trace.Pose pose) {
    if (pose.offset() == 0.0 && pose.heading() == 0.0) {
      System.arraycopy(backgroundRange, 0, range, 0, RAYS);
      System.arraycopy(backgroundIntensity, 0, intensity, 0, RAYS);
      boxes.forEach(this::see);
    } else {
      look(boxes, pose);
    }
    return noisy();
  }

  /** Casts each ray from where the lidar is, which is slower than to look straight ahead. */
  private void look(List<Box> boxes, Trace.Pose pose) {
    double cos = StrictMath.cos(pose.heading());
    double sin = StrictMath.sin(pose.heading());
    double along = -behindBumper * cos;
    double across = pose.offset() - behindBumper * sin;
    for (int ray = 0; ray < RAYS; ray++) {
      double dx = DIRECTION_X[ray] * cos - DIRECTION_Y[ray] * sin;
      double dy = DIRECTION_X[ray] * sin + DIRECTION_Y[ray] * cos;
      double wallAt = Math.copySign(RoadScene.WALL_DISTANCE, dy) - across;
      background(ray, wallAt / dy, range, intensity);
      for (Box box : boxes) {
        double distance = distance(dx, dy, DIRECTION_Z[ray], box, along, across);
        if (distance < range[ray]) {
          range[ray] = (float) distance;
          intensity[ray] = box.intensity();
        }
      }
    }
  }

  /** Where a ray from a place enters a box: after the last of its entries into the three slabs. */
  private double distance(double dx, double dy, double dz, Box box, double along, double across) {
    double enter = Math.max(entry(box.rear() - along, box.front() - along, dx), 0.0);
    enter = Math.max(enter, entry(box.right() - across, box.left() - across, dy));
    enter = Math.max(enter, entry(-aboveRoad, box.height() - aboveRoad, dz));
    double exit = -entry(along - box.front(), along - box.rear(), dx);
    exit = Math.min(exit, -entry(across - box.left(), across - box.right(), dy));
    exit = Math.min(exit, -entry(aboveRoad - box.height(), aboveRoad, dz));
    return enter <= exit && enter > 0.0 ? enter : Double.POSITIVE_INFINITY;
  }

  /** When a ray enters a slab; never if it runs beside it, and always if it runs within. */
  private static double entry(double low, double high, double direction) {
    if (direction == 0.0) {
      return low <= 0.0 && high >= 0.0 ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }
    return Math.min(low / direction, high / direction);
  }

  private byte[] noisy() {
    int offset = 0;
    int start = random.nextInt(NOISE.length);
    for (int ray = 0; ray < RAYS; ray++) {
      if (range[ray] <= RANGE) {
        double distance = range[ray] + noise * NOISE[(start + ray) & (NOISE.length - 1)];
        FLOAT.set(points, offset, (float) (distance * DIRECTION_X[ray]));
        FLOAT.set(points, offset + 4, (float) (distance * DIRECTION_Y[ray]));
        FLOAT.set(points, offset + 8, (float) (distance * DIRECTION_Z[ray]));
        FLOAT.set(points, offset + 12, intensity[ray]);
        offset += POINT_STEP;
      }
    }
    return Arrays.copyOf(points, offset);
  }

  /** Shortens the rays that hit a box. */
  private void see(Box box) {
    double near = box.rear() + behindBumper;
    double far = box.front() + behindBumper;
    int first = azimuthIndex(box.right(), box.right() < 0.0 ? near : far);
    int last = azimuthIndex(box.left(), box.left() > 0.0 ? near : far) + 1;
    for (int ring = 0; ring < ELEVATIONS.length; ring++) {
      for (int azimuth = Math.max(0, first); azimuth <= Math.min(AZIMUTHS - 1, last); azimuth++) {
        int ray = ring * AZIMUTHS + azimuth;
        double distance = distance(ray, near, far, box);
        if (distance < range[ray]) {
          range[ray] = (float) distance;
          intensity[ray] = box.intensity();
        }
      }
    }
  }

  /** The last azimuth that is not left of a place; places beside or behind the lidar saturate. */
  private static int azimuthIndex(double y, double x) {
    double azimuth = StrictMath.toDegrees(StrictMath.atan2(y, x));
    return (int) Math.floor((azimuth + HALF_VIEW) / STEP);
  }

  /**
   * Where a ray enters a box: the last of the entries into its three slabs, if before the exits.
   */
  private double distance(int ray, double near, double far, Box box) {
    double dx = DIRECTION_X[ray];
    double dy = DIRECTION_Y[ray];
    double dz = DIRECTION_Z[ray];
    double enterX = near / dx;
    double exitX = far / dx;
    double enterY = (dy > 0.0 ? box.right() : box.left()) / dy;
    double exitY = (dy > 0.0 ? box.left() : box.right()) / dy;
    if (dy == 0.0) {
      boolean between = box.right() <= 0.0 && box.left() >= 0.0;
      enterY = between ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
      exitY = between ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
    }
    double top = box.height() - aboveRoad;
    double enterZ = dz < 0.0 ? top / dz : -aboveRoad / dz;
    double exitZ = dz < 0.0 ? -aboveRoad / dz : top / dz;
    double enter = Math.max(enterX, Math.max(enterY, enterZ));
    double exit = Math.min(exitX, Math.min(exitY, exitZ));
    return enter <= exit && enter > 0.0 ? enter : Double.POSITIVE_INFINITY;
  }
}
