package dev.eventchain.simulation.sensor;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.LidarSettings;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Trace;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;

/**
 * A roof lidar that looks ahead. Each ray of its rings returns the nearest point of road, walls and
 * boxes, with noise along the ray, or nothing.
 */
public final class Lidar {

  /** Length of one point in bytes: x, y, z and intensity as float32. */
  public static final int POINT_STEP = 16;

  /** Value of float32 in PointField. */
  private static final int FLOAT32 = 7;

  /** Longest range, in m. */
  static final double RANGE = 100.0;

  /** Angle between the directions of an outline, in degrees. */
  private static final double OUTLINE = 2.0;

  private static final float ROAD_INTENSITY = 0.2f;
  private static final float WALL_INTENSITY = 0.4f;

  /** Standard normal numbers; a scan uses a slice of them from a random position. */
  private static final float[] NOISE = noise();

  private final LidarSettings settings;
  private final SplittableRandom random;
  private final SplittableRandom dropouts;
  private final LidarRays rays;
  private final float[] straightRange;
  private final float[] straightIntensity;
  private final float[] range;
  private final float[] intensity;
  private final float[] points;

  public Lidar(LidarSettings settings, long seed) {
    this.settings = settings;
    this.random = new SplittableRandom(seed);
    this.dropouts = new SplittableRandom(~seed);
    this.rays = LidarRays.withStep(settings.azimuthStep());
    this.straightRange = new float[rays.count()];
    this.straightIntensity = new float[rays.count()];
    this.range = new float[rays.count()];
    this.intensity = new float[rays.count()];
    this.points = new float[rays.count() * POINT_STEP / Float.BYTES];
    background(Road.straight(), new Road.Place(0.0, 0.0, 0.0), straightRange, straightIntensity);
  }

  private static float[] noise() {
    Random gaussian = new Random(1);
    float[] values = new float[1 << 14];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) gaussian.nextGaussian();
    }
    return values;
  }

  /** Sets the constant fields in the messages of scans. */
  public static void describe(MessageValue message) {
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

  /** Writes one scan into a message, except its header. */
  public void scan(RoadScene scene, MessageValue message) {
    byte[] scanned = scan(scene);
    message.set("width", (long) scanned.length / POINT_STEP);
    message.set("row_step", (long) scanned.length);
    message.set("data", scanned);
  }

  /**
   * Returns one scan, as the data of a PointCloud2 in the lidar's frame (x forward, y left, z up).
   *
   * @return {@link #POINT_STEP} bytes for each ray with an echo
   */
  public byte[] scan(RoadScene scene) {
    Road.Place place = scene.ego().ahead(-settings.behindBumper());
    boolean usual = scene.road().isFurnished() && scene.road().isStraight();
    if (usual && place.y() == 0.0 && place.heading() == 0.0) {
      System.arraycopy(straightRange, 0, range, 0, rays.count());
      System.arraycopy(straightIntensity, 0, intensity, 0, rays.count());
    } else {
      background(scene.road(), place, range, intensity);
    }
    for (Body body : scene.bodies()) {
      see(body, place);
    }
    return returned();
  }

  /**
   * Returns the nearest echo, except the road's, about every two degrees of the last scan, for
   * display.
   */
  public Trace.Outline outline(RoadScene scene, double time) {
    Road.Place place = scene.ego().ahead(-settings.behindBumper());
    List<Double> x = new ArrayList<>();
    List<Double> y = new ArrayList<>();
    int step = Math.max(1, (int) Math.round(OUTLINE / settings.azimuthStep()));
    for (int azimuth = 0; azimuth < rays.azimuths(); azimuth += step) {
      double nearest = Double.POSITIVE_INFINITY;
      for (int ray = azimuth; ray < rays.count(); ray += rays.azimuths()) {
        if (intensity[ray] != ROAD_INTENSITY && range[ray] <= RANGE) {
          nearest = Math.min(nearest, range[ray] * StrictMath.hypot(rays.x(ray), rays.y(ray)));
        }
      }
      if (nearest <= RANGE) {
        double heading = place.heading() + rays.azimuth(azimuth);
        Road.Place echo = new Road.Place(place.x(), place.y(), heading).ahead(nearest);
        x.add(echo.x());
        y.add(echo.y());
      }
    }
    return new Trace.Outline(time, x, y);
  }

  /**
   * Computes road and walls, which are the same at every place in the middle of a straight lane.
   */
  private void background(Road road, Road.Place place, float[] ranges, float[] intensities) {
    double cos = StrictMath.cos(place.heading());
    double sin = StrictMath.sin(place.heading());
    double height = settings.aboveRoad();
    for (int ray = 0; ray < rays.count(); ray++) {
      double dx = rays.x(ray) * cos - rays.y(ray) * sin;
      double dy = rays.x(ray) * sin + rays.y(ray) * cos;
      double dz = rays.z(ray);
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
    LidarBox box =
        new LidarBox(body, x * cos + y * sin, y * cos - x * sin, place, settings.aboveRoad());
    int first = box.beside() ? 0 : Math.max(0, rays.azimuthIndex(box.rightmost()));
    int last = rays.azimuths() - 1;
    if (!box.beside()) {
      last = Math.min(last, rays.azimuthIndex(box.leftmost()) + 1);
    }
    for (int ring = 0; ring < rays.count(); ring += rays.azimuths()) {
      LidarBox.Span vertical = box.between(rays.z(ring));
      if (vertical.exit() <= 0.0) {
        continue;
      }
      for (int ray = ring + first; ray <= ring + last; ray++) {
        double distance = box.distance(rays.x(ray), rays.y(ray), vertical, range[ray]);
        if (distance < range[ray]) {
          range[ray] = (float) distance;
          intensity[ray] = body.intensity();
        }
      }
    }
  }

  private byte[] returned() {
    int count = 0;
    int start = random.nextInt(NOISE.length);
    float noise = (float) settings.noise();
    boolean drops = settings.dropout() > 0.0;
    for (int ray = 0; ray < range.length; ray++) {
      if (range[ray] <= RANGE && !(drops && dropouts.nextDouble() < settings.dropout())) {
        double distance = range[ray] + noise * NOISE[(start + ray) & (NOISE.length - 1)];
        points[count++] = (float) (distance * rays.x(ray));
        points[count++] = (float) (distance * rays.y(ray));
        points[count++] = (float) (distance * rays.z(ray));
        points[count++] = intensity[ray];
      }
    }
    ByteBuffer data = ByteBuffer.allocate(count * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    data.asFloatBuffer().put(points, 0, count);
    return data.array();
  }
}
