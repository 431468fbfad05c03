package dev.eventchain.roads.reader;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.roads.link.LaneGraph;
import dev.eventchain.roads.road.Header;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.Signal;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.ElementTable;
import dev.eventchain.roads.xml.Place;
import dev.eventchain.roads.xml.Problems;
import dev.eventchain.roads.xml.XmlRules;
import dev.eventchain.roads.xml.XmlStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reader of a file's parts, one after the other. */
public final class NetworkReader {

  private static final int NEWEST_MINOR = 8;
  private static final int OLDEST_KNOWN_MINOR = 4;

  private final Problems problems = new Problems();
  private final PendingLinks links = new PendingLinks();
  private final RoadReader roadReader = new RoadReader(problems, links);
  private final Map<String, Road> roads = new LinkedHashMap<>();
  private final Map<String, Junction> junctions = new LinkedHashMap<>();
  private final Map<String, Place> places = new LinkedHashMap<>();
  private final List<Signal.Controller> controllers = new ArrayList<>();
  private Header header;

  /**
   * Reads a text.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException with all problems of the text, if any is
   *     an error
   */
  public static ReadNetwork read(SourceText source) {
    NetworkReader reader = new NetworkReader();
    XmlStream.read(source, reader.problems, reader::handle);
    return reader.network(SourceLocation.of(source.at(0).file()));
  }

  private void handle(CheckedElement element) {
    ElementTable.check(element, problems);
    switch (element.name()) {
      case "header" -> header = header(element);
      case "road" -> road(element);
      case "junction" -> junction(element);
      case "controller" -> controllers.add(controller(element));
      default -> {} // The table has said what it is.
    }
  }

  private Header header(CheckedElement element) {
    if (header != null) {
      problems.add(
          RoadRules.DUPLICATE, element, "There is a second `header`.", "Remove one of them.");
    }
    double major = element.number("revMajor");
    double minor = element.number("revMinor");
    requireVersion(element, major, minor);
    Header.Offset offset =
        element
            .child("offset")
            .map(
                child ->
                    new Header.Offset(
                        child.number("x"),
                        child.number("y"),
                        child.number("z", 0),
                        child.number("hdg", 0)))
            .orElse(new Header.Offset(0, 0, 0, 0));
    String projection = element.child("geoReference").map(CheckedElement::text).orElse("");
    return new Header(
        (int) minor,
        element.optional("name").orElse(""),
        element.optional("vendor").orElse(""),
        projection,
        offset);
  }

  private void requireVersion(CheckedElement element, double major, double minor) {
    // What is no number is reported where it is read.
    boolean unknown = major < 1 || major > 1 || minor > NEWEST_MINOR || minor < 0;
    if (unknown) {
      problems.add(
          RoadRules.VERSION,
          element,
          "The file is of OpenDRIVE " + (int) major + "." + (int) minor + ".",
          "Known are 1.4 to 1." + NEWEST_MINOR + ": export the file in one of these versions.");
    } else if (minor < OLDEST_KNOWN_MINOR) {
      problems.add(
          RoadRules.VERSION_OLD,
          element,
          "The file is of OpenDRIVE 1." + (int) minor + ", and is read as one of 1.4.",
          "Compare its roads with what made the file, or export it in a newer version.");
    }
  }

  private void road(CheckedElement element) {
    String id = element.string("id");
    if (isNew("road", id, element)) {
      roadReader.read(id, element).ifPresent(road -> roads.put(id, road));
    }
  }

  private void junction(CheckedElement element) {
    String id = element.string("id");
    if (isNew("junction", id, element)) {
      junctions.put(id, JunctionReader.read(id, element, links));
    }
  }

  /** Notes an id; reports one that is used a second time. */
  private boolean isNew(String kind, String id, CheckedElement element) {
    Place before = places.putIfAbsent(kind + " " + id, element.place());
    if (before != null) {
      problems.add(
          RoadRules.DUPLICATE,
          element,
          "There is a second " + kind + " `" + id + "`.",
          "The first one is on line " + before.location().line() + ": rename or remove one.");
    }
    return before == null;
  }

  private static Signal.Controller controller(CheckedElement element) {
    return new Signal.Controller(
        element.string("id"),
        element.optional("name").orElse(""),
        element.children("control").stream().map(each -> each.string("signalId")).toList());
  }

  private ReadNetwork network(SourceLocation file) {
    if (header == null) {
      problems.add(
          XmlRules.ELEMENT_MISSING,
          file,
          "The file has no `header`.",
          "Add a header with `revMajor` and `revMinor`.");
    }
    if (roads.isEmpty() && problems.errors() == 0) {
      problems.add(
          RoadRules.EMPTY, file, "The file has no road.", "Name a file with at least one road.");
    }
    boolean complete = problems.errors() == 0;
    // Where a road could not be read, links to its lanes would be found wrong, too.
    LaneGraph graph =
        complete ? new LaneGraphBuilder(roads, junctions, problems).graph(links) : null;
    return new ReadNetwork(header, roads, controllers, graph, problems.warnings());
  }
}
