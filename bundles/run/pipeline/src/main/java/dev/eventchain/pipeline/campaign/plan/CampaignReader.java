package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.scenario.NumberFormulas;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/** Reads campaign files. */
public final class CampaignReader {

  private static final NumberRange CASES = NumberRange.of(1, 1_000_000);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);
  private static final NumberRange REPETITIONS = NumberRange.of(1, 1000);

  private final Path file;
  private final boolean isSearched;
  private final SourceText text;

  private CampaignReader(Path file, boolean isSearched) {
    this.file = file;
    this.isSearched = isSearched;
    this.text = SourceText.read(file);
  }

  /**
   * Reads a campaign file.
   *
   * @return its campaigns, in its order
   * @throws DiagnosticException (INPUT) with every problem of the file
   */
  public static List<CampaignPlan> read(Path file) {
    return new CampaignReader(file, false).read();
  }

  /**
   * Reads a campaign file for a search, which goes between the bounds of factors by itself.
   *
   * @throws DiagnosticException (INPUT) with every problem of the file
   */
  public static List<CampaignPlan> readForSearch(Path file) {
    return new CampaignReader(file, true).read();
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
    List<CampaignPlan> plans = new ArrayList<>();
    document.object("campaigns").ifPresent(section -> plans.addAll(named(section)));
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
    List<Factor> factors = section.requiredObject("factors").map(this::factors).orElse(List.of());
    Sampling sampling = section.object("sampling").map(this::sampling).orElse(Sampling.USUAL);
    requireFit(section, factors, sampling);
    List<Computed> computed = computedOf(section, factors);
    List<SourceRange> conditions = conditions(section);
    int repetitions = (int) section.wholeNumber("repetitions", REPETITIONS).orElse(1);
    long seed = section.wholeNumber("seed", SEED).orElse(1);
    Optional<CampaignPlan.Boundary> boundary =
        section.object("boundary").flatMap(it -> boundary(it, factors, sampling));
    SearchSettings search =
        section.object("search").map(SearchSettings::read).orElse(SearchSettings.USUAL);
    section.refuseOthers();
    String name = file.getFileName().toString().replaceFirst("\\.ya?ml$", "");
    return new CampaignPlan(
        file,
        part,
        part.map(own -> name + "-" + own).orElse(name),
        scenario,
        factors,
        computed,
        sampling,
        conditions,
        repetitions,
        seed,
        boundary,
        search);
  }

  /** Requires of the factors that their values can be combined as asked for. */
  private void requireFit(ObjectReader section, List<Factor> factors, Sampling sampling) {
    if (!sampling.kind().isDrawn() && !isSearched) {
      factors.stream()
          .filter(factor -> factor.levels().isContinuous())
          .forEach(factor -> section.find(undrawn(factor)));
    }
    if (sampling.kind() == Sampling.Kind.ROWS && tables(factors) != 1) {
      String message = "Rows need factors that are all columns of one table.";
      section.find(CampaignRules.VALUE_RANGE, message, section.at("sampling"));
    }
  }

  private List<Computed> computedOf(ObjectReader section, List<Factor> factors) {
    Optional<ObjectReader> formulas = section.object("computed");
    List<Computed> computed = formulas.map(it -> computed(it, factors)).orElse(List.of());
    if (computed.size() == formulas.map(it -> it.names().size()).orElse(0)) {
      requireUse(section, factors, computed);
    } // else nobody knows what the formulas read that cannot be read
    return computed;
  }

  /** Returns how many tables the factors are from; 0 if one is from none. */
  private static long tables(List<Factor> factors) {
    return factors.stream().allMatch(factor -> factor.levels() instanceof Levels.Column)
        ? factors.stream().map(it -> ((Levels.Column) it.levels()).table()).distinct().count()
        : 0;
  }

  private List<Computed> computed(ObjectReader section, List<Factor> factors) {
    List<String> known = new ArrayList<>(factors.stream().map(Factor::name).toList());
    List<Computed> computed = new ArrayList<>();
    for (String name : section.names()) {
      requireName(section, name, "A factor");
      if (known.contains(name)) {
        String message = "There is a factor '" + name + "' already.";
        section.find(CampaignRules.KEY_DUPLICATE, message, section.atKey(name));
      }
      section
          .object(name)
          .flatMap(part -> computed(name, part, new NumberFormulas(known)))
          .ifPresent(computed::add);
      known.add(name);
    }
    return computed;
  }

  private Optional<Computed> computed(String name, ObjectReader part, NumberFormulas formulas) {
    List<String> paths = paths(part);
    String formula = part.requiredText("formula");
    part.refuseOthers();
    if (formula.isEmpty()) {
      return Optional.empty();
    }
    try {
      SourceRange range = SourceText.within(part.at("formula"), formula).whole();
      return Optional.of(new Computed(name, paths, formulas.quantity(range), part.location()));
    } catch (DiagnosticException e) {
      Diagnostic first = e.diagnostics().get(0);
      part.find(
          Diagnostic.of(CampaignRules.FORMULA, first.message(), part.at("formula"))
              .withHint(first.hint()));
      return Optional.empty();
    }
  }

  /** Requires of each factor and of what is computed that the scenario or a formula reads it. */
  private static void requireUse(
      ObjectReader section, List<Factor> factors, List<Computed> computed) {
    Set<String> read = new HashSet<>();
    computed.forEach(each -> read.addAll(each.formula().names()));
    Map<String, SourceLocation> idle = new LinkedHashMap<>();
    factors.stream()
        .filter(each -> each.paths().isEmpty())
        .forEach(each -> idle.put(each.name(), each.place()));
    computed.stream()
        .filter(each -> each.paths().isEmpty())
        .forEach(each -> idle.put(each.name(), each.place()));
    idle.keySet().removeAll(read);
    idle.values()
        .forEach(
            place ->
                section.find(
                    Diagnostic.of(CampaignRules.KEY_MISSING, "'path' is missing.", place)
                        .withHint(
                            "Write the number of the scenario that it is, such as ego.speed_kmh, or"
                                + " read it in a formula under `computed`.")));
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

  private List<SourceRange> conditions(ObjectReader section) {
    List<SourceRange> conditions = new ArrayList<>();
    List<String> texts = section.texts("where");
    for (int i = 0; i < texts.size(); i++) {
      conditions.add(SourceText.within(section.at("where"), texts.get(i)).whole());
    }
    return conditions;
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

  private static void requireName(ObjectReader section, String name, String what) {
    if (!name.matches("[A-Za-z_][A-Za-z0-9_]*")) {
      String message = what + " has a name of letters, digits and underscores.";
      section.find(CampaignRules.VALUE_RANGE, message, section.atKey(name));
    }
  }

  private static List<String> paths(ObjectReader part) {
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
    return Optional.of(new CampaignPlan.Boundary(index.getAsInt(), BigDecimal.valueOf(resolution)));
  }
}
