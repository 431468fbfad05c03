package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/** Reads campaign files. */
public final class CampaignReader {

  private static final NumberRange CASES = NumberRange.of(1, 1_000_000);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);
  private static final NumberRange REPETITIONS = NumberRange.of(1, 1000);

  private static final String FACTORS = "factors";
  private static final String WHERE = "where";

  private final Path file;
  private final Purpose purpose;
  private final SourceText text;
  private final CriteriaByTags criteria = new CriteriaByTags();

  private CampaignReader(Path file, SourceText text, Purpose purpose) {
    this.file = file;
    this.purpose = purpose;
    this.text = text;
  }

  /**
   * Reads a campaign file.
   *
   * @return its campaigns, in its order
   * @throws DiagnosticException (INPUT) with every problem of the file
   */
  public static List<CampaignPlan> read(Path file) {
    return read(file, SourceText.read(file));
  }

  /**
   * As above, from a text.
   *
   * @param file the file that it is in, or would be in
   */
  public static List<CampaignPlan> read(Path file, SourceText text) {
    return new CampaignReader(file, text, Purpose.CAMPAIGN).read();
  }

  /**
   * Reads a campaign file for a search, which goes between the bounds of factors by itself.
   *
   * @throws DiagnosticException (INPUT) with every problem of the file
   */
  public static List<CampaignPlan> readForSearch(Path file) {
    return new CampaignReader(file, SourceText.read(file), Purpose.SEARCH).read();
  }

  private List<CampaignPlan> read() {
    List<Diagnostic> problems = new ArrayList<>();
    Document document =
        Document.parse(text, DocumentFormat.YAML, CampaignRules.OF_DOCUMENTS, problems::add);
    Optional<List<CampaignPlan>> plans = document.object("", problems::add).map(this::plans);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return plans.orElseThrow();
  }

  private List<CampaignPlan> plans(ObjectReader document) {
    if (!document.has("campaigns")) {
      return List.of(plan(document, Optional.empty()));
    }
    document.text("description"); // for people
    criteria.ofFile(document);
    List<CampaignPlan> plans = new ArrayList<>();
    document.object("campaigns").ifPresent(section -> plans.addAll(named(section)));
    criteria.refuseIdle(document);
    document.refuseOthers();
    return plans;
  }

  private List<CampaignPlan> named(ObjectReader section) {
    List<CampaignPlan> plans = new ArrayList<>();
    for (String name : section.names()) {
      requireName(section, name, "A campaign");
      section.object(name).ifPresent(part -> plans.add(plan(part, Optional.of(name))));
    }
    if (section.names().isEmpty()) {
      section.find(CampaignRules.EMPTY, "There is no campaign.", section.location());
    }
    return plans;
  }

  private CampaignPlan plan(ObjectReader section, Optional<String> part) {
    String scenario = section.requiredText("scenario");
    section.text("description"); // for people
    List<CaseCriteria> given = criteria.of(section);
    Optional<PlayedScenario> played = PlayedScenario.read(file, scenario, section, given);
    List<Factor> factors = factors(section, played);
    Sampling sampling = sampling(section, factors, played);
    List<SourceRange> conditions = conditions(section);
    FormulasOfCases.Read formulas =
        FormulasOfCases.read(section, factors, allConditions(conditions, given));
    CampaignPlan plan =
        new CampaignPlan(
            file,
            part,
            name(part),
            scenario,
            played,
            factors,
            formulas.computed(),
            sampling,
            conditions,
            given,
            (int) section.wholeNumber("repetitions", REPETITIONS).orElse(1),
            section.wholeNumber("seed", SEED).orElse(1),
            section.object("boundary").flatMap(it -> boundary(it, factors, sampling)),
            section.object("search").map(SearchSettings::read).orElse(SearchSettings.USUAL),
            formulas.points());
    section.refuseOthers();
    return plan;
  }

  private static List<SourceRange> allConditions(
      List<SourceRange> own, List<CaseCriteria> criteria) {
    return Stream.concat(own.stream(), criteria.stream().flatMap(it -> it.conditions().stream()))
        .toList();
  }

  /** Returns the name of a campaign's results. */
  private String name(Optional<String> part) {
    String name = file.getFileName().toString().replaceFirst("\\.ya?ml$", "");
    return part.map(own -> name + "-" + own).orElse(name);
  }

  /** Returns the factors; of a file in OpenSCENARIO XML, without any, what varies in it. */
  private List<Factor> factors(ObjectReader section, Optional<PlayedScenario> played) {
    if (played.isPresent() && !section.has(FACTORS)) {
      PlayedScenario file = played.get();
      Optional<Diagnostic> refusal = PlayedScenario.refusal(file.file(), file.varied(), purpose);
      refusal.ifPresent(section::find);
      return refusal.isPresent() ? List.of() : file.factors(section.at("scenario"));
    }
    List<Factor> stated = section.requiredObject(FACTORS).map(this::factors).orElse(List.of());
    return played.map(file -> stated.stream().map(file::addressed).toList()).orElse(stated);
  }

  private Sampling sampling(
      ObjectReader section, List<Factor> factors, Optional<PlayedScenario> played) {
    Sampling unstated =
        section.has(FACTORS)
            ? Sampling.USUAL
            : played.map(file -> file.sampling(purpose)).orElse(Sampling.USUAL);
    Sampling sampling = section.object("sampling").map(this::sampling).orElse(unstated);
    requireFit(section, factors, sampling);
    return sampling;
  }

  /** Requires of the factors that their values can be combined as asked for. */
  private void requireFit(ObjectReader section, List<Factor> factors, Sampling sampling) {
    if (!sampling.kind().isDrawn() && purpose == Purpose.CAMPAIGN) {
      factors.stream()
          .filter(factor -> factor.levels().isContinuous())
          .forEach(factor -> section.find(undrawn(factor)));
    }
    if (sampling.kind() == Sampling.Kind.ROWS && tables(factors) != 1) {
      String message = "Rows need factors that are all columns of one table.";
      section.find(CampaignRules.VALUE_RANGE, message, section.at("sampling"));
    }
  }

  /** Returns how many tables the factors are from; 0 if one is from none. */
  private static long tables(List<Factor> factors) {
    return factors.stream().allMatch(factor -> factor.levels() instanceof Levels.Column)
        ? factors.stream().map(it -> ((Levels.Column) it.levels()).table()).distinct().count()
        : 0;
  }

  private static Diagnostic undrawn(Factor factor) {
    return Diagnostic.of(
            CampaignRules.SIZE,
            "The values of '"
                + factor.name()
                + "' have to be drawn, and a grid has no end of them.",
            factor.place())
        .withHint("Write, for example, `sampling: {latin_hypercube: 200}`, or values or steps.");
  }

  /** Returns the conditions of a campaign, or of some of its criteria. */
  static List<SourceRange> conditions(ObjectReader section) {
    return section.texts(WHERE).stream()
        .map(text -> SourceText.within(section.at(WHERE), text).whole())
        .toList();
  }

  private List<Factor> factors(ObjectReader section) {
    List<Factor> factors = new ArrayList<>();
    for (String name : section.names()) {
      requireName(section, name, "A factor");
      section.object(name).ifPresent(part -> factors.add(factor(name, part)));
    }
    if (factors.isEmpty()) {
      section.find(CampaignRules.EMPTY, "There is no factor.", section.location());
    }
    return factors;
  }

  static void requireName(ObjectReader section, String name, String what) {
    if (!name.matches("[A-Za-z_][A-Za-z0-9_]*")) {
      String message = what + " has a name of letters, digits and underscores.";
      section.find(CampaignRules.VALUE_RANGE, message, section.atKey(name));
    }
  }

  static List<String> paths(ObjectReader part) {
    List<String> paths = new ArrayList<>(part.texts("paths"));
    part.text("path").ifPresent(paths::add);
    return paths;
  }

  private Factor factor(String name, ObjectReader part) {
    List<String> paths = paths(part);
    Levels levels = LevelsReader.read(file, part);
    part.refuseOthers();
    return new Factor(name, paths, levels, part.location());
  }

  private Sampling sampling(ObjectReader part) {
    List<Sampling.Kind> kinds =
        Arrays.stream(Sampling.Kind.values()).filter(kind -> part.has(kind.key())).toList();
    Sampling.Kind kind = kinds.isEmpty() ? Sampling.Kind.GRID : kinds.get(0);
    if (kinds.size() != 1) {
      String known = "One of grid, rows, pairs, random, latin_hypercube and halton is needed.";
      part.find(CampaignRules.VALUE_RANGE, known, part.location());
      kinds.forEach(each -> part.value(each.key()));
    } else if (!kind.isDrawn()) {
      part.requireTrue(kind.key());
    }
    int cases = kind.isDrawn() ? (int) part.requiredWholeNumber(kind.key(), CASES) : 0;
    part.refuseOthers();
    return new Sampling(kind, cases);
  }

  private static Optional<CampaignPlan.Boundary> boundary(
      ObjectReader part, List<Factor> factors, Sampling sampling) {
    String name = part.requiredText("factor");
    double resolution = part.requiredNumber("resolution", NumberRange.of(1e-9, 1e12));
    Optional<SearchSettings.Named> criterion = SearchSettings.criterion(part);
    part.refuseOthers();
    List<String> names = factors.stream().map(Factor::name).toList();
    OptionalInt index =
        OptionalInt.of(names.indexOf(name)).stream().filter(it -> it >= 0).findFirst();
    if (index.isEmpty()) {
      part.find(
          Diagnostic.of(
                  CampaignRules.FACTOR, "There is no factor '" + name + "'.", part.at("factor"))
              .withHint(NearestName.hint(name, names)));
      return Optional.empty();
    }
    if (sampling.kind() != Sampling.Kind.GRID) {
      String message = "A boundary is searched from a grid on.";
      part.find(CampaignRules.VALUE_RANGE, message, part.location());
    }
    Levels levels = factors.get(index.getAsInt()).levels();
    if (!levels.isContinuous() && levels.checked().size() < 2) {
      String message = "'" + name + "' has one value, and a boundary lies between two.";
      part.find(CampaignRules.VALUE_RANGE, message, part.at("factor"));
    }
    BigDecimal plain =
        new BigDecimal(BigDecimal.valueOf(resolution).stripTrailingZeros().toPlainString());
    return Optional.of(new CampaignPlan.Boundary(index.getAsInt(), plain, criterion));
  }
}
