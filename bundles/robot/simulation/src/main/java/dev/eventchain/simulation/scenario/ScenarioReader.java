package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.formula.ActorSignals;
import dev.eventchain.simulation.formula.Range;
import dev.eventchain.simulation.stage.PlayedFile;
import dev.eventchain.simulation.stage.PlayedFiles;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;

/** Reads scenario files, with units in the names of the keys, into SI units. */
final class ScenarioReader {

  private static final DocumentRules RULES =
      new DocumentRules(
          ScenarioRules.SYNTAX,
          ScenarioRules.KEY_DUPLICATE,
          ScenarioRules.VALUE_TYPE,
          ScenarioRules.KEY_MISSING,
          ScenarioRules.KEY_UNKNOWN,
          ScenarioRules.VALUE_RANGE);
  private static final NumberRange DURATION = NumberRange.of(0.1, 600);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);

  private final SourceText text;
  private final Bench bench;
  private final boolean varying;
  private final BooleanSupplier sound;

  /**
   * Creates a reader.
   *
   * @param varying whether formulas are refused that are true or false in every run
   * @param sound returns whether there is no problem yet
   */
  private ScenarioReader(SourceText text, Bench bench, boolean varying, BooleanSupplier sound) {
    this.text = text;
    this.bench = bench;
    this.varying = varying;
    this.sound = sound;
  }

  /**
   * Reads a file that has one scenario; several cases are refused, so that none gets lost.
   *
   * @param files what was read before of others to which it leads
   */
  static Scenario readOnly(
      SourceText text,
      Bench bench,
      boolean varying,
      PlayedFiles files,
      Consumer<Diagnostic> warnings) {
    List<Scenario> scenarios = read(text, bench, varying, files, warnings);
    if (scenarios.size() > 1) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  ScenarioRules.VALUE_RANGE,
                  String.format(
                      Locale.ROOT,
                      "Its OpenSCENARIO file has %d cases, and one is needed here.",
                      scenarios.size()),
                  scenarios.get(0).location())
              .withHint(
                  "Name the scenario that the distributions are about, and vary its parameters."));
    }
    return scenarios.get(0);
  }

  /**
   * Reads a file, which has one scenario, or several cases of one.
   *
   * @param warnings receives what to know about other files to which it leads
   */
  static List<Scenario> read(SourceText text, Bench bench, Consumer<Diagnostic> warnings) {
    return read(text, bench, true, new PlayedFiles(), warnings);
  }

  private static List<Scenario> read(
      SourceText text,
      Bench bench,
      boolean varying,
      PlayedFiles files,
      Consumer<Diagnostic> warnings) {
    List<Diagnostic> problems = new ArrayList<>();
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, problems::add);
    List<Optional<PlayedFile>> cases =
        document
            .object("", problems::add)
            .map(whole -> cases(whole, Path.of(text.name()), files))
            .orElse(List.of());
    List<Scenario> scenarios = new ArrayList<>();
    ScenarioReader reader = new ScenarioReader(text, bench, varying, problems::isEmpty);
    for (Optional<PlayedFile> each : cases) {
      if (problems.isEmpty() || scenarios.isEmpty()) {
        document
            .object("", problems::add)
            .ifPresent(it -> scenarios.add(reader.scenario(it, document::at, each)));
      }
    }
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    cases.stream()
        .flatMap(Optional::stream)
        .flatMap(each -> each.warnings().stream())
        .distinct()
        .forEach(warnings);
    return scenarios;
  }

  /** Returns what is played in each case; nothing in the only one of a file that plays nothing. */
  private static List<Optional<PlayedFile>> cases(
      ObjectReader whole, Path file, PlayedFiles files) {
    return whole.has(OpenScenarioReader.KEY)
        ? OpenScenarioReader.read(whole, file, files).stream().map(Optional::of).toList()
        : List.of(Optional.empty());
  }

  /** Reads the files to which a scenario leads, if it leads to any. */
  static void played(SourceText text) {
    if (!mayPlay(text.text())) {
      return;
    }
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, finding -> {});
    document
        .object("", finding -> {})
        .filter(section -> section.has(OpenScenarioReader.KEY))
        .ifPresent(section -> OpenScenarioReader.visit(section, Path.of(text.name())));
  }

  /**
   * Returns whether a text may have the key: campaigns ask again and again while they run, and to
   * parse all scenarios takes long. Only an escape could hide a key.
   */
  private static boolean mayPlay(String text) {
    return text.contains(OpenScenarioReader.KEY) || text.indexOf('\\') >= 0;
  }

  /**
   * Reads a scenario.
   *
   * @param parts returns the locations of its parts
   * @param played what has its situation; empty if the file itself has it
   */
  private Scenario scenario(
      ObjectReader section, Function<String, SourceLocation> parts, Optional<PlayedFile> played) {
    Words words = words(section, played);
    NamedRequirements requirements = NamedRequirements.ofScenario(section);
    long seed = section.wholeNumber("seed", SEED).orElse(1);
    section.has(OpenScenarioReader.KEY);
    double duration = duration(section, played);
    SituationReader reader = new SituationReader(section, text, bench, longest(section));
    Situation situation = played.map(reader::read).orElseGet(reader::read);
    Map<String, Script> inputs =
        section.object("inputs").map(part -> InputsReader.read(part, bench)).orElse(Map.of());
    Optional<Range.Source> ranges =
        Optional.<Range.Source>of(new SignalRanges(situation, inputs, bench, longest(section)))
            .filter(it -> varying && played.isEmpty());
    List<String> actors = SituationReader.names(situation.actors());
    ActorSignals signals = new ActorSignals(bench.signals(), actors, situation.events());
    FormulasReader formulas =
        new FormulasReader(text, signals, longest(section), requirements, ranges);
    NodePhases phases = section.object("phases_ms").map(NodePhases::read).orElse(NodePhases.NONE);
    Asked asked = asked(section, formulas);
    if (sound.getAsBoolean()) { // A criterion with an error may be the one that needs an input.
      InputsReader.requireUse(section, reader.notAwaited(inputs.keySet()), asked, bench);
    }
    section.refuseOthers();
    Scenario.Heading heading = heading(words, requirements, parts, section, played);
    return new Scenario(heading, seed, duration, situation, inputs, phases, asked);
  }

  /** Statements of a scenario about itself. */
  private record Words(String name, String title, String description) {}

  private static Words words(ObjectReader section, Optional<PlayedFile> played) {
    String name = name(section);
    String description = section.text("description").orElse("").strip().replaceAll("\\s+", " ");
    return new Words(
        name + played.map(PlayedFile::suffix).orElse(""),
        section.requiredText("title") + played.map(PlayedFile::words).orElse(""),
        description);
  }

  /** Returns names and requirements, once all criteria are read. */
  private Scenario.Heading heading(
      Words words,
      NamedRequirements requirements,
      Function<String, SourceLocation> parts,
      ObjectReader section,
      Optional<PlayedFile> played) {
    SourceLocation whole = section.location();
    return new Scenario.Heading(
        words.name(),
        words.title(),
        words.description(),
        requirements.all(),
        requirements.places(),
        // Of a case, of which there are many, nobody asks where its parts are.
        varying ? parts : part -> whole,
        played.map(PlayedFile::end));
  }

  private static Asked asked(ObjectReader section, FormulasReader formulas) {
    List<Expectation> criteria =
        section
            .requiredObject("accept")
            .map(part -> CriteriaReader.read(part, formulas))
            .orElse(List.of());
    NamedRequirements requirements = formulas.requirements();
    return new Asked(
        requirements.distributed(criteria),
        formulas.readConditions(section),
        formulas.readObserved(section),
        requirements.judged(),
        formulas.optional().locations());
  }

  private static String name(ObjectReader section) {
    String name = section.requiredText("name");
    if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*") && !name.isBlank()) {
      String message = "A name consists of lower-case letters, digits and hyphens.";
      section.find(ScenarioRules.VALUE_RANGE, message, section.at("name"));
    }
    return name;
  }

  /** Returns the duration, which a file with a trigger that stops it need not have. */
  private static double duration(ObjectReader section, Optional<PlayedFile> played) {
    return played.filter(PlayedFile::stops).isPresent() && !section.has("duration_s")
        ? PlayedFile.LONGEST
        : section.requiredNumber("duration_s", DURATION);
  }

  /**
   * Returns the duration; the maximum if it is invalid, so that no interval is rejected because of
   * it.
   */
  private static double longest(ObjectReader section) {
    return section
        .value("duration_s")
        .map(JsonNode::doubleValue)
        .filter(seconds -> seconds >= DURATION.least() && seconds <= DURATION.most())
        .orElse(DURATION.most());
  }
}
