package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.HumanDriver;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.SpeedProfile;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * Reads the sections {@code actors} and {@code furniture} of a scenario, and the scripts of all
 * actors.
 */
final class ActorsReader {

  /** Factor from km/h to m/s. */
  static final double KMH = 1.0 / 3.6;

  private static final Rule RANGE_FINDING = ScenarioRules.VALUE_RANGE;
  private static final NumberRange GAP = NumberRange.of(-2000, 2000);
  private static final NumberRange SIZE = NumberRange.of(0.01, 200);
  private static final NumberRange HEIGHT = NumberRange.of(0, 20);
  private static final NumberRange ANGLE = NumberRange.of(-180, 180);
  private static final NumberRange COUNT = NumberRange.of(1, 200);

  private final double duration;
  private final Set<String> names = new HashSet<>();

  /** The names that the file gives, which no numbered one may equal. */
  private final Set<String> given = new HashSet<>();

  private final Map<String, Integer> unnamed = new HashMap<>();
  private final Map<String, SourceLocation> places = new HashMap<>();
  private final Map<String, ManeuversReader> scripts = new HashMap<>();

  /**
   * Creates a reader.
   *
   * @param duration of the scenario, in s: later changes are rejected
   */
  ActorsReader(double duration) {
    this.duration = duration;
  }

  /** Reads all actors and furniture, in the order of the file. */
  List<Actor> read(ObjectReader scenario) {
    List<Actor> actors = new ArrayList<>();
    List<ObjectReader> sections = scenario.objects("actors");
    sections.forEach(each -> each.value("name").ifPresent(name -> given.add(name.asText())));
    sections.forEach(each -> actor(each).ifPresent(actors::add));
    scenario.objects("furniture").forEach(each -> actors.addAll(furniture(each)));
    return actors;
  }

  private Optional<Actor> actor(ObjectReader section) {
    Optional<ActorKind> kind = kind(section, true, ActorKind.CAR.id());
    double gap = section.requiredNumber("gap_m", GAP);
    double speed = section.requiredNumber("speed_kmh", ManeuversReader.SPEED_KMH) * KMH;
    double offset = section.number("lateral_offset_m", ManeuversReader.ASIDE).orElse(0);
    double heading = heading(section);
    Optional<Actor.Size> size = kind.map(each -> size(section, each));
    String name = name(section, kind.orElse(ActorKind.CAR));
    ManeuversReader maneuvers = new ManeuversReader(section, duration);
    SpeedProfile profile = maneuvers.speed(speed);
    LateralProfile line = maneuvers.line(offset, profile);
    boolean straight = section.has("keeps_heading");
    section.requireTrue("keeps_heading");
    section.refuseOthers();
    places.put(name, section.at("gap_m"));
    scripts.put(name, maneuvers);
    return kind.map(each -> new Actor(name, each, size.orElseThrow(), gap, heading, profile, line))
        .map(actor -> straight ? actor.withoutTurning() : actor);
  }

  /** Adds the maneuvers that begin by themselves, which may be about any actor. */
  List<Actor> completed(List<Actor> actors, CircumstancesReader circumstances) {
    return actors.stream()
        .map(
            actor ->
                Optional.ofNullable(scripts.get(actor.name()))
                    .map(it -> actor.then(it.begun(), it.waiting(circumstances)))
                    .orElse(actor))
        .toList();
  }

  /** Adds the maneuvers of the driver that begin by themselves. */
  HumanDriver completed(HumanDriver driver, ObjectReader ego, CircumstancesReader circumstances) {
    ManeuversReader maneuvers = new ManeuversReader(ego, duration);
    return driver.then(maneuvers.begun(), maneuvers.waiting(circumstances));
  }

  /** Returns the location of an actor's distance. */
  SourceLocation place(Actor actor) {
    return places.get(actor.name());
  }

  private List<Actor> furniture(ObjectReader section) {
    if (!section.has("kind")) {
      section.find(ScenarioRules.KEY_MISSING, "'kind' is missing.", section.location());
    }
    Optional<ActorKind> kind = kind(section, false, ActorKind.PARKED_CAR.id());
    double gap = section.requiredNumber("gap_m", GAP);
    double offset = section.number("lateral_offset_m", ManeuversReader.ASIDE).orElse(0);
    double heading = heading(section);
    Optional<Actor.Size> size = kind.map(each -> size(section, each));
    long count = section.wholeNumber("count", COUNT).orElse(1);
    OptionalDouble spacing = section.number("spacing_m", SIZE);
    requireBoth(section);
    section.refuseOthers();
    List<Actor> row = new ArrayList<>();
    for (int i = 0; i < count && kind.isPresent(); i++) {
      String name = numbered(kind.get());
      places.put(name, section.at("gap_m"));
      row.add(
          new Actor(
              name,
              kind.get(),
              size.orElseThrow(),
              gap + i * spacing.orElse(0),
              heading,
              new SpeedProfile(0, List.of()),
              new LateralProfile(offset, List.of())));
    }
    return row;
  }

  private static void requireBoth(ObjectReader section) {
    if (section.has("count") != section.has("spacing_m")) {
      String present = section.has("count") ? "count" : "spacing_m";
      section.find(RANGE_FINDING, "A row needs both count and spacing_m.", section.at(present));
    }
  }

  private static double heading(ObjectReader section) {
    return StrictMath.toRadians(section.number("heading_deg", ANGLE).orElse(0));
  }

  private static Optional<ActorKind> kind(ObjectReader section, boolean moving, String usual) {
    String id = section.text("kind").orElse(usual);
    Optional<ActorKind> kind = ActorKind.find(id, moving);
    if (kind.isEmpty()) {
      List<String> known = ActorKind.ids(moving);
      String other =
          ActorKind.find(id, !moving).isPresent()
              ? "It belongs under '" + (moving ? "furniture" : "actors") + "'."
              : NearestName.of(id, known)
                  .map(name -> "Did you mean '" + name + "'?")
                  .orElse("Use one of: " + String.join(", ", known) + ".");
      section.find(
          Diagnostic.of(RANGE_FINDING, "'" + id + "' is not allowed here.", section.at("kind"))
              .withHint(other));
    }
    return kind;
  }

  private static Actor.Size size(ObjectReader section, ActorKind kind) {
    Actor.Size usual = kind.size();
    double bottom = section.number("bottom_m", HEIGHT).orElse(usual.bottom());
    double top = section.number("height_m", HEIGHT).orElse(usual.top());
    if (bottom >= top) {
      section.find(
          RANGE_FINDING,
          "Its lower bound is not below its upper one.",
          section.at(section.has("height_m") ? "height_m" : "bottom_m"));
    }
    return new Actor.Size(
        section.number("length_m", SIZE).orElse(usual.length()),
        section.number("width_m", SIZE).orElse(usual.width()),
        bottom,
        top);
  }

  private String name(ObjectReader section, ActorKind kind) {
    Optional<String> name = section.text("name");
    if (name.isEmpty()) {
      return numbered(kind);
    }
    if (name.get().isBlank() || !names.add(name.get())) {
      section.find(
          RANGE_FINDING,
          name.get().isBlank() ? "This is not a name." : "Two have the name '" + name.get() + "'.",
          section.at("name"));
    }
    return name.get();
  }

  /** Returns a numbered name, such as "car 2". */
  private String numbered(ActorKind kind) {
    String name;
    do {
      int number = unnamed.merge(kind.id(), 1, Integer::sum);
      name = kind.id().replace('_', ' ') + " " + number;
    } while (given.contains(name));
    return name;
  }

  /** Reads the driver of the ego, whose script is among the ego's keys. */
  HumanDriver driver(ObjectReader ego, double speed, double offset) {
    ManeuversReader maneuvers = new ManeuversReader(ego, duration);
    SpeedProfile profile = maneuvers.speed(speed);
    LateralProfile line = maneuvers.line(offset, profile);
    boolean steers = ego.has("driver_steers") || maneuvers.steer();
    ego.requireTrue("driver_steers");
    return new HumanDriver(profile, line, steers);
  }
}
