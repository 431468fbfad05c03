package dev.eventchain.roads;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.roads.geo.GeoReference;
import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.link.LaneGraph;
import dev.eventchain.roads.reader.NetworkReader;
import dev.eventchain.roads.reader.ReadNetwork;
import dev.eventchain.roads.road.Header;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.Signal;
import dev.eventchain.roads.xml.XmlRules;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A road network of an ASAM OpenDRIVE file, 1.4 to 1.8. Immutable. */
public final class RoadNetwork {

  private static final long LARGEST = 100L << 20;

  private final Header header;
  private final Map<String, Road> roads;
  private final List<Signal.Controller> controllers;
  private final LaneGraph graph;
  private final List<Diagnostic> findings;
  private final Locator locator;

  private RoadNetwork(ReadNetwork read) {
    this.header = read.header();
    this.roads = read.roads();
    this.controllers = read.controllers();
    this.graph = read.graph();
    this.findings = read.warnings();
    this.locator = new Locator(this.roads.values());
  }

  /**
   * Reads a file.
   *
   * @throws DiagnosticException with all problems of the file, if any is an error
   */
  public static RoadNetwork read(Path file) {
    requireSize(file);
    return parse(SourceText.read(file));
  }

  private static void requireSize(Path file) {
    FileReads.note(file);
    try {
      if (Files.isRegularFile(file) && Files.size(file) > LARGEST) {
        throw new DiagnosticException(
            Reason.INPUT,
            Diagnostic.of(
                    XmlRules.SIZE,
                    "The file has "
                        + Files.size(file)
                        + " bytes; at most "
                        + LARGEST
                        + " are read.",
                    SourceLocation.of(file))
                .withHint("Export a part of the network."));
      }
    } catch (IOException e) {
      // What reads the file says why it cannot be read.
      return;
    }
  }

  /**
   * Reads a text.
   *
   * @throws DiagnosticException with all problems of the text, if any is an error
   */
  public static RoadNetwork parse(SourceText source) {
    return new RoadNetwork(NetworkReader.read(source));
  }

  /** Returns the warnings about the file, in the order of discovery. */
  public List<Diagnostic> findings() {
    return findings;
  }

  /** Returns the header. */
  public Header header() {
    return header;
  }

  /** Returns all roads in the order of the file; at least one. */
  public Collection<Road> roads() {
    return roads.values();
  }

  /** Returns a road. */
  public Optional<Road> road(String id) {
    return Optional.ofNullable(roads.get(id));
  }

  /** Returns the controllers of signals in the order of the file. */
  public List<Signal.Controller> controllers() {
    return controllers;
  }

  LaneGraph graph() {
    return graph;
  }

  /**
   * Returns why latitudes and longitudes have no place in the network, as the end of a sentence;
   * empty if they have one.
   */
  public Optional<String> geoProblem() {
    return new GeoReference(header.geoReference()).problem();
  }

  /**
   * Returns the place of a latitude and longitude, in degrees, and an altitude, in m.
   *
   * @throws IllegalStateException if there is a {@link #geoProblem()}
   */
  public Pose geo(double latitude, double longitude, double altitude) {
    GeoReference reference = new GeoReference(header.geoReference());
    if (reference.problem().isPresent()) {
      throw new IllegalStateException(reference.problem().get());
    }
    double[] projected = reference.project(latitude, longitude);
    Header.Offset offset = header.offset();
    double x = projected[0] - offset.x();
    double y = projected[1] - offset.y();
    double cos = StrictMath.cos(offset.heading());
    double sin = StrictMath.sin(offset.heading());
    return new Pose(x * cos + y * sin, y * cos - x * sin, altitude - offset.z(), 0, 0, 0);
  }

  /**
   * Returns the position by a road at a place: where several roads are, that with the lane whose
   * middle is nearest. Empty beside all roads.
   */
  public Optional<RoadPosition> locate(double x, double y) {
    return locator.locate(x, y, Optional.empty());
  }

  /**
   * Returns the position by a road at a place, by the road of an earlier position as long as the
   * place is on it.
   */
  public Optional<RoadPosition> locate(double x, double y, RoadPosition near) {
    return locator.locate(x, y, road(near.road()));
  }

  /** Returns the position by the nearest road, also beside all roads. */
  public RoadPosition nearest(double x, double y) {
    return locator.nearest(x, y);
  }

  /**
   * Returns the pose of the middle of a lane with its offset, in the direction of s. Empty if there
   * is no such road or lane, or s is not on the road.
   */
  public Optional<Pose> pose(LanePosition position) {
    return t(position).map(t -> road(position.road()).orElseThrow().pose(position.s(), t));
  }

  /** Returns t of a position; empty if there is no such position. */
  Optional<Double> t(LanePosition position) {
    Optional<Road> road =
        road(position.road())
            .filter(
                found -> Math.abs(found.inside(position.s()) - position.s()) < Profile.ROUNDING);
    return road.map(found -> found.section(position.s()))
        .filter(section -> section.lane(position.lane()).isPresent())
        .map(section -> section.centre(position.lane(), position.s()) + position.offset());
  }

  /**
   * Returns the path that leads along the lane of a position and the lanes that are linked to it,
   * in the direction of traffic on it. Where lanes divide, it takes the road that turns least.
   *
   * @param behind the length before the position, in m; the path has more, to the end of the lane's
   *     section, or less if the lanes end before
   * @param ahead the same behind the position
   * @return empty if there is no such position
   */
  public Optional<LanePath> path(LanePosition position, double behind, double ahead) {
    return lane(position)
        .flatMap(
            lane ->
                path(
                    position,
                    road(position.road()).orElseThrow().leads(lane, true),
                    behind,
                    ahead));
  }

  /**
   * As {@link #path(LanePosition, double, double)} in a direction of its own.
   *
   * @param alongS whether the path leads along s at the position, or else against it
   */
  public Optional<LanePath> path(
      LanePosition position, boolean alongS, double behind, double ahead) {
    return lane(position)
        .map(lane -> new LanePaths(this).path(position, alongS, behind, ahead, Optional.empty()));
  }

  /**
   * As {@link #path(LanePosition, double, double)} along a route, and changing lanes where the lane
   * does not lead on along the route.
   *
   * @param route from the position on
   * @return empty if there is no such position, or the route does not begin on its road
   */
  public Optional<LanePath> path(LanePosition position, Route route, double behind) {
    Optional<Lane> lane = lane(position);
    Route.Leg first = route.legs().get(0);
    return lane.filter(found -> first.road().equals(position.road()))
        .map(
            found ->
                new LanePaths(this)
                    .path(position, first.alongS(), behind, route.length(), Optional.of(route)));
  }

  private Optional<Lane> lane(LanePosition position) {
    // Lane 0 is a line, along which nothing drives.
    return t(position)
        .filter(t -> position.lane() != 0)
        .flatMap(t -> road(position.road()).orElseThrow().lane(position.s(), position.lane()));
  }

  /**
   * Returns the shortest route over positions, in the direction of traffic and with changes of
   * lanes as needed.
   *
   * @param waypoints at least two
   * @return empty if there is none, or no such position
   */
  public Optional<Route> route(List<LanePosition> waypoints) {
    return waypoints.stream().allMatch(each -> lane(each).isPresent())
        ? new RouteSearch(this).route(waypoints)
        : Optional.empty();
  }

  /**
   * Returns the position relative to another one, as OpenSCENARIO's {@code RelativeLanePosition}
   * has it.
   *
   * @param lanes by how many lanes it is to the left, counted along s without lane 0
   * @param distance along s, over the links of the lane; below 0 against s, in m
   * @return empty if there is no such position
   */
  public Optional<LanePosition> relative(LanePosition from, int lanes, double distance) {
    return lane(from).flatMap(lane -> new RelativePositions(this).of(from, lanes, distance));
  }
}
