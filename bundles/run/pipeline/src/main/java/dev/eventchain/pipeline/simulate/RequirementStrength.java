package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.project.StrengthExtent;
import dev.eventchain.pipeline.project.StrengthSettings;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.RequirementOutcome.Bound;
import dev.eventchain.pipeline.results.RequirementOutcome.Nearest;
import dev.eventchain.pipeline.results.RequirementOutcome.Unnoticed;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.SimulationOptions;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.Strength;
import dev.eventchain.simulation.verdict.StrengthBudget;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;

/** The strength of the evidence for a project's requirements, and what is missing. */
public final class RequirementStrength {

  /** The number of unnoticed faults that a line names. */
  private static final int NAMED = 3;

  private final Optional<Strength> strength;
  private final StrengthSettings settings;
  private final List<WrittenRequirement> written;

  RequirementStrength(
      Optional<Strength> strength, StrengthSettings settings, List<WrittenRequirement> written) {
    this.strength = strength;
    this.settings = settings;
    this.written = written;
  }

  static RequirementStrength of(RunContext run, SimulationResult result) {
    return new RequirementStrength(
        result.strength(), run.project().configuration().strength(), run.writtenRequirements());
  }

  /** Returns how far strength is to be measured where a run can. */
  static StrengthExtent extent(RunContext run) {
    return run.options()
        .simulation()
        .strength()
        .orElse(run.project().configuration().strength().extent());
  }

  /** Returns the budget of the measurement; empty if a run does not measure strength. */
  static Optional<StrengthBudget> budget(RunContext run) {
    return whyNot(run).isEmpty()
        ? Optional.of(run.project().configuration().strength().budget(extent(run)))
        : Optional.empty();
  }

  /** Returns why a run does not measure strength, whatever its result; empty if it does. */
  static String whyNot(RunContext run) {
    RunOptions options = run.options();
    if (extent(run) == StrengthExtent.OFF) {
      return options.simulation().strength().isPresent()
          ? "switched off"
          : "the project does not want it";
    }
    if (options.isPartial()) {
      return "only some scenarios were simulated";
    }
    return options.simulation().driver() == SimulationOptions.Driver.LOCKSTEP
        ? ""
        : "only the driver lockstep can";
  }

  /** Returns whether a requirement is not tested although its scenarios passed. */
  boolean isUntested(String id) {
    return find(id).filter(each -> each.noticed() == 0 || !each.needed()).isPresent();
  }

  private List<Strength.Requirement> measured() {
    return strength.map(Strength::requirements).orElse(List.of());
  }

  /** Returns a finding for each requirement whose criteria notice too little. */
  List<Diagnostic> findings() {
    List<Diagnostic> found = new ArrayList<>();
    for (WrittenRequirement item : written) {
      find(item.id()).ifPresent(each -> finding(item, each).ifPresent(found::add));
    }
    return found;
  }

  private Optional<Strength.Requirement> find(String id) {
    return measured().stream().filter(each -> each.id().equals(id)).findFirst();
  }

  private Optional<Diagnostic> finding(WrittenRequirement item, Strength.Requirement measured) {
    if (measured.noticed() == 0) {
      return Optional.of(none(item, measured));
    }
    if (!measured.needed()) {
      return Optional.of(idle(item, measured));
    }
    Strength.Requirement counted = measured.counted();
    return counted.percent() >= settings.minimumOf(item.id())
        ? Optional.empty()
        : Optional.of(low(item, measured, counted));
  }

  private static Diagnostic none(WrittenRequirement item, Strength.Requirement measured) {
    String message =
        measured.faults() == 0
            ? "No standard fault of %s changes anything in the scenarios that name %s, so its criteria cannot notice any."
                .formatted(components(measured), item.id())
            : String.format(
                Locale.ROOT,
                "The criteria of %s notice none of %d standard faults of %s: %s.",
                item.id(),
                measured.faults(),
                components(measured),
                named(measured));
    return finding(
        item,
        SimulateRules.SIMULATION_STRENGTH_NONE,
        message,
        "Let a scenario that names it need what the component does, with a criterion that fails without it");
  }

  private static Diagnostic idle(WrittenRequirement item, Strength.Requirement measured) {
    return finding(
        item,
        SimulateRules.SIMULATION_STRENGTH_IDLE,
        "No criterion of any scenario notices when %s sends nothing%s, or always the same, so nothing shows that it does what %s asks for."
            .formatted(components(measured), on(measured), item.id()),
        "Add a scenario in which the component has to react, with a criterion that fails if it does not");
  }

  /**
   * Returns the finding that too few faults are noticed.
   *
   * @param counted the strength on the faults that count
   */
  private Diagnostic low(
      WrittenRequirement item, Strength.Requirement measured, Strength.Requirement counted) {
    if (counted.faults() == 0) {
      return uncounted(item, counted);
    }
    return finding(
        item,
        SimulateRules.SIMULATION_STRENGTH_LOW,
        String.format(
            Locale.ROOT,
            "The criteria of %s notice %d of %d standard faults%s: %.1f %% and not %.1f %%. Not: %s.",
            item.id(),
            counted.noticed(),
            counted.faults(),
            counting(measured, counted),
            counted.percent(),
            settings.minimumOf(item.id()),
            named(counted)),
        "Add criteria that notice them");
  }

  private Diagnostic uncounted(WrittenRequirement item, Strength.Requirement counted) {
    return finding(
        item,
        SimulateRules.SIMULATION_STRENGTH_LOW,
        String.format(
            Locale.ROOT,
            "No standard fault of %s counts for the bound of %s, %.1f %%: none changes a message in its scenarios on an output that may be for it.",
            components(counted),
            item.id(),
            settings.minimumOf(item.id())),
        "Let a scenario that names it need what the component does");
  }

  /** Returns which faults count, in words; empty if all faults of its only component do. */
  private static String counting(Strength.Requirement measured, Strength.Requirement counted) {
    long others =
        measured.reactions().stream()
            .filter(each -> counted.components().contains(each.component()))
            .filter(Strength.Reaction::elsewhere)
            .count();
    if (others == 0 && measured.components().size() == 1) {
      return "";
    }
    String these = " of %s that count for the bound".formatted(components(counted));
    return others == 0
        ? these
        : these
            + String.format(
                Locale.ROOT, ", without %d of outputs that other requirements judge", others);
  }

  private static Diagnostic finding(
      WrittenRequirement item, Rule rule, String message, String hint) {
    return Diagnostic.of(rule, message, item.location())
        .withRule(item.id())
        .withHint(hint + ", or suppress this finding with a reason and an expiry date.");
  }

  private static String components(Strength.Requirement measured) {
    return String.join(
        " and ", measured.components().stream().map(name -> "'" + name + "'").toList());
  }

  /** Returns the outputs of which a requirement asks for one, in words; empty for any output. */
  private static String on(Strength.Requirement measured) {
    return measured.outputs().isEmpty() ? "" : " on " + String.join(" or ", measured.outputs());
  }

  private static String named(Strength.Requirement measured) {
    return named(measured.unnoticed().stream().map(Strength.Reaction::fault).toList());
  }

  /** Returns the first of some faults and the number of the others. */
  private static String named(List<String> faults) {
    String first = String.join("; ", faults.subList(0, Math.min(NAMED, faults.size())));
    return faults.size() <= NAMED ? first : first + "; and " + (faults.size() - NAMED) + " more";
  }

  /** Returns the strength of a requirement; empty if it was not measured. */
  Optional<RequirementOutcome.Strength> of(String id) {
    return find(id).map(this::strength);
  }

  private RequirementOutcome.Strength strength(Strength.Requirement measured) {
    return new RequirementOutcome.Strength(
        measured.noticed(),
        measured.faults(),
        sampleOf(measured),
        bound(measured),
        measured.unnoticed().stream().map(RequirementStrength::unnoticed).toList());
  }

  /** Returns the number of all faults that may change something; empty if all were tried. */
  private static OptionalLong sampleOf(Strength.Requirement measured) {
    return measured.leftOut().isEmpty()
        ? OptionalLong.empty()
        : OptionalLong.of(measured.faults() + measured.leftOut().size());
  }

  /** Returns what counts for the bound of a requirement; empty if the project states none. */
  private Optional<Bound> bound(Strength.Requirement measured) {
    double minimum = settings.minimumOf(measured.id());
    Strength.Requirement counted = measured.counted();
    return minimum > 0
        ? Optional.of(
            new Bound(
                minimum,
                counted.components(),
                counted.noticed(),
                counted.faults(),
                sampleOf(counted)))
        : Optional.empty();
  }

  private static Unnoticed unnoticed(Strength.Reaction reaction) {
    Nearest nearest =
        new Nearest(
            reaction.scenario(),
            reaction.criterion(),
            reaction.margin().map(SimulationReport::margin));
    return new Unnoticed(
        reaction.fault(), reaction.criterion().isEmpty() ? Optional.empty() : Optional.of(nearest));
  }

  /**
   * Returns why strength was not measured, or the size of the sample, for people; empty if all
   * faults were driven.
   */
  static Optional<String> limited(RunContext run, SimulationResult result) {
    if (result.strength().isPresent()) {
      return result.strength().filter(Strength::isSample).map(RequirementStrength::sample);
    }
    String why = whyNot(run);
    return Optional.of("not measured: " + (why.isEmpty() ? "not every scenario passed" : why));
  }

  private static String sample(Strength strength) {
    return String.format(
        Locale.ROOT, "a sample of %d of %d standard faults", strength.tried(), strength.faults());
  }

  /** Returns what a stage says of it: the number of runs, or that there is no measurement. */
  static String details(RunContext run, SimulationResult result) {
    if (result.strength().isPresent()) {
      Strength strength = result.strength().get();
      String faults = strength.isSample() ? sample(strength) : "standard faults";
      return String.format(
          Locale.ROOT,
          " %d runs with %s in %.0f simulated s,",
          strength.runs(),
          faults,
          strength.seconds());
    }
    return run.options().isPartial() || !result.passed() ? "" : " strength not measured,";
  }

  /**
   * Returns the strength of a requirement in words, "notices 9 of 11 faults, a sample of 40", with
   * those that it does not notice.
   */
  public static String words(RequirementOutcome.Strength strength) {
    String words =
        String.format(
            Locale.ROOT, "notices %d of %d faults", strength.noticed(), strength.faults());
    if (strength.sampleOf().isPresent()) {
      words += ", a sample of " + strength.sampleOf().getAsLong();
    }
    return strength.unnoticed().isEmpty()
        ? words
        : words + ", not: " + named(strength.unnoticed().stream().map(Unnoticed::fault).toList());
  }
}
