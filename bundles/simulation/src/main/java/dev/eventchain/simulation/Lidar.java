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

  /**
   * How it is mounted, and what it gets wrong.
   *
   * @param behindBumper from the front bumper back to the lidar, in m
   * @param aboveRoad from the road up to the lidar, in m
   * @param noise standard deviation of a measured range, in m
   * @param dropout part of the rays that return nothing although something is there, 0 to 1
   */
  record Settings(double behindBumper, double aboveRoad, double noise, double dropout) {

    /** The mounting that the AEB example's object detection knows. */
    static final Settings USUAL = new Settings(2.4, 2.4, 0.01, 0.0);
  }

  /** Length of one point in bytes: x, y, z and intensity as float32. */
  static final int POINT_STEP = 16;

  /** What PointField calls a float32. */
  private static final int FLOAT32 = 7;

  /** Longest range, in m. */
  static final double RANGE = 100.0;

  /** Elevation of the rings, in degrees: those of a Velodyne VLP-32C (its data sheet). */
  private static final double[] ELEVATIONS = {
    15.0, 10.333, 7.0, 4.667, 3.333, 2.333, 1.667, 1.333, 1.0, 0.667, 0.333, 0.0, -0.333, -0.667,
    -1.0, -1.333, -1.667, -2.0, -2.333, -2.667, -3.0, -3.333, -3.667, -4.0, -4.667, -5.333, -6.148,
    -7.254, -8.843, -11.31, -15.639, -25.0
  };

  private static final double HALF_VIEW = 60.0;
  private static final double STEP = 0.5;
  private static final int AZIMUTHS = (int) (2 * HALF_VIEW / STEP) + 1;
  private static final int RAYS = ELEVATIONS.length * AZIMUTHS;

  /** Directions from one of an outline to the next. */
  private static final int OUTLINE = 4;

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

  private final Settings settings;
  private final SplittableRandom random;
  private final SplittableRandom dropouts;
  private final float[] straightRange = new float[RAYS];
  private final float[] straightIntensity = new float[RAYS];
  private final float[] range = new float[RAYS];
  private final float[] intensity = new float[RAYS];
  private final byte[] points = new byte[RAYS * POINT_STEP];

  Lidar(Settings settings, long seed) {
    this.settings = settings;
    this.random = new SplittableRandom(seed);
    this.dropouts = new SplittableRandom(~seed);
    background(Road.STRAIGHT, new Road.Place(0.0, 0.0, 0.0), straightRange, straightIntensity);
  }

  private static float[] noise() {
    Random gaussian = new Random(1);
    float[] values = new float[1 << 14];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) gaussian.nextGaussian();
    }
    return values;
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
  void scan(RoadScene scene, MessageValue message) {
    byte[] scanned = scan(scene);
    message.set("width", (long) scanned.length / POINT_STEP);
    message.set("row_step", (long) scanned.length);
    message.set("data", scanned);
  }

  /**
   * One scan, as the data of a PointCloud2 in the lidar's frame (x forward, y left, z up).
   *
   * @return {@link #POINT_STEP} bytes for each ray that returned
   */
  byte[] scan(RoadScene scene) {
    Road.Place place = scene.ego().ahead(-settings.behindBumper());
    if (scene.road().curvature() == 0.0 && place.y() == 0.0 && place.heading() == 0.0) {
      System.arraycopy(straightRange, 0, range, 0, RAYS);
      System.arraycopy(straightIntensity, 0, intensity, 0, RAYS);
    } else {
      background(scene.road(), place, range, intensity);
    }
    for (Body body : scene.bodies()) {
      see(body, place);
    }
    return returned();
  }

  /** The nearest echo but for the road's in every fourth direction of the last scan, for people. */
  ScenarioVerdict.Scan outline(RoadScene scene, double time) {
    Road.Place place = scene.ego().ahead(-settings.behindBumper());
    List<Double> x = new ArrayList<>();
    List<Double> y = new ArrayList<>();
    for (int azimuth = 0; azimuth < AZIMUTHS; azimuth += OUTLINE) {
      float nearest = Float.POSITIVE_INFINITY;
      for (int ray = azimuth; ray < RAYS; ray += AZIMUTHS) {
        if (intensity[ray] != ROAD_INTENSITY && range[ray] <= RANGE) {
          double flat = StrictMath.hypot(DIRECTION_X[ray], DIRECTION_Y[ray]);
          nearest = (float) Math.min(nearest, range[ray] * flat);
        }
      }
      if (nearest <= RANGE) {
        double turned = StrictMath.toRadians(azimuth * STEP - HALF_VIEW);
        Road.Place echo =
            new Road.Place(place.x(), place.y(), place.heading() + turned).ahead(nearest);
        x.add(echo.x());
        y.add(echo.y());
      }
    }
    return new ScenarioVerdict.Scan(time, x, y);
  }

  /** Road and walls, which look the same from every place in the middle of a straight lane. */
  private void background(Road road, Road.Place place, float[] ranges, float[] intensities) {
    double cos = StrictMath.cos(place.heading());
    double sin = StrictMath.sin(place.heading());
    double height = settings.aboveRoad();
    for (int ray = 0; ray < RAYS; ray++) {
      double dx = DIRECTION_X[ray] * cos - DIRECTION_Y[ray] * sin;
      double dy = DIRECTION_X[ray] * sin + DIRECTION_Y[ray] * cos;
      double dz = DIRECTION_Z[ray];
      double wall = road.wall(place, dx, dy);
      double ground = dz < 0.0 ? height / -dz : Double.POSITIVE_INFINITY;
      boolean hitsWall = wall < ground && height + wall * dz <= RoadScene.WALL_HEIGHT;
      ranges[ray] = (float) (hitsWall ? wall : ground);
      intensities[ray] = hitsWall ? WALL_INTENSITY : ROAD_INTENSITY;
    }
  }

  /** Shortens the rays that hit a box. */
  private void see(Body body, Road.Place place) {
    double x = body.place().x() - place.x();
    double y = body.place().y() - place.y();
    double cos = StrictMath.cos(place.heading());
    double sin = StrictMath.sin(place.heading());
    Box box = new Box(body, x * cos + y * sin, y * cos - x * sin, place, settings.aboveRoad());
    int first = box.beside() ? 0 : azimuthIndex(box.rightmost());
    int last = box.beside() ? AZIMUTHS - 1 : azimuthIndex(box.leftmost()) + 1;
    for (int ring = 0; ring < ELEVATIONS.length; ring++) {
      for (int azimuth = Math.max(0, first); azimuth <= Math.min(AZIMUTHS - 1, last); azimuth++) {
        int ray = ring * AZIMUTHS + azimuth;
        double distance = box.distance(DIRECTION_X[ray], DIRECTION_Y[ray], DIRECTION_Z[ray]);
        if (distance < range[ray]) {
          range[ray] = (float) distance;
          intensity[ray] = body.intensity();
        }
      }
    }
  }

  /** The last azimuth that is not left of a direction. */
  private static int azimuthIndex(double direction) {
    return (int) Math.floor((StrictMath.toDegrees(direction) + HALF_VIEW) / STEP);
  }

  /** A box as the lidar sees it: in the lidar's frame, turned. */
  private static final class Box {

    private final double x;
    private final double y;
    private final double cos;
    private final double sin;
    private final double halfLength;
    private final double halfWidth;
    private final double bottom;
    private final double top;
    private double leftmost = Double.NEGATIVE_INFINITY;
    private double rightmost = Double.POSITIVE_INFINITY;
    private boolean beside;

    Box(Body body, double x, double y, Road.Place lidar, double aboveRoad) {
      double turned = body.place().heading() - lidar.heading();
      this.cos = StrictMath.cos(turned);
      this.sin = StrictMath.sin(turned);
      // The lidar as the box has it.
      this.x = -(x * cos + y * sin);
      this.y = x * sin - y * cos;
      this.halfLength = body.length() / 2;
      this.halfWidth = body.width() / 2;
      this.bottom = body.bottom() - aboveRoad;
      this.top = body.top() - aboveRoad;
      for (int corner = 0; corner < 4; corner++) {
        double along = (corner & 1) == 0 ? halfLength : -halfLength;
        double aside = (corner & 2) == 0 ? halfWidth : -halfWidth;
        double ahead = x + along * cos - aside * sin;
        double left = y + along * sin + aside * cos;
        beside |= ahead <= 0.0;
        double azimuth = StrictMath.atan2(left, ahead);
        leftmost = Math.max(leftmost, azimuth);
        rightmost = Math.min(rightmost, azimuth);
      }
    }

    /** Whether a part of it is not ahead of the lidar. */
    boolean beside() {
      return beside;
    }

    double leftmost() {
      return leftmost;
    }

    double rightmost() {
      return rightmost;
    }

    /** Where a ray enters it: after the last of its entries into the three slabs. */
    double distance(double dx, double dy, double dz) {
      double along = dx * cos + dy * sin;
      double aside = dy * cos - dx * sin;
      double enter = entry(-halfLength - x, halfLength - x, along);
      enter = Math.max(enter, entry(-halfWidth - y, halfWidth - y, aside));
      enter = Math.max(enter, entry(bottom, top, dz));
      double exit = -entry(x - halfLength, x + halfLength, along);
      exit = Math.min(exit, -entry(y - halfWidth, y + halfWidth, aside));
      exit = Math.min(exit, -entry(-top, -bottom, dz));
      return enter <= exit && enter > 0.0 ? enter : Double.POSITIVE_INFINITY;
    }

    /** When a ray enters a slab; never if it runs beside it, and always if it runs within. */
    private static double entry(double low, double high, double direction) {
      if (direction == 0.0) {
        return low <= 0.0 && high >= 0.0 ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
      }
      return Math.min(low / direction, high / direction);
    }
  }

  private byte[] returned() {
    int offset = 0;
    int start = random.nextInt(NOISE.length);
    float noise = (float) settings.noise();
    for (int ray = 0; ray < RAYS; ray++) {
      if (range[ray] <= RANGE && !dropped()) {
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

  private boolean dropped() {
    return settings.dropout() > 0.0 && dropouts.nextDouble() < settings.dropout();
  }
}
