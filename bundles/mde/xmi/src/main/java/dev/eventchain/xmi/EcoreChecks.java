package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Checks that models are valid instances of their metamodels, as EMF's own validator does for any
 * object. The findings are {@code ecore.required} and {@code ecore.bound} for multiplicities,
 * {@code ecore.opposite}, {@code ecore.unique}, {@code ecore.value} for values that a data type
 * does not allow (and {@code ecore.limit} if its patterns take too long), {@code ecore.key} and
 * {@code ecore.map}. Ids and unresolved references are checked when files are read.
 */
public final class EcoreChecks {

  private static final List<Rule> RULES =
      List.of(
          EcoreRules.REQUIRED,
          EcoreRules.BOUND,
          EcoreRules.OPPOSITE,
          EcoreRules.UNIQUE,
          EcoreRules.VALUE,
          EcoreRules.KEY,
          EcoreRules.MAP);

  private static final Duration TIME_LIMIT = Duration.ofSeconds(30);

  /** The checks of a class, and the number of its instances so far. */
  private static final class Planned {
    private final EcorePlan plan;
    private long instances;

    private Planned(EcorePlan plan) {
      this.plan = plan;
    }

    private static Planned of(EClass type) {
      return new Planned(EcorePlan.of(type));
    }
  }

  private final Function<EObject, SourceLocation> locator;
  private final Map<EClass, Planned> plans = new HashMap<>();
  private final Map<Rule, Long> evaluations = new LinkedHashMap<>();
  private final List<Diagnostic> found = new ArrayList<>();
  private final ValueChecks values;

  private EcoreChecks(Function<EObject, SourceLocation> locator, Duration timeLimit) {
    this.locator = locator;
    this.values = new ValueChecks(locator, timeLimit);
    RULES.forEach(rule -> evaluations.put(rule, 0L));
  }

  /** As {@link #of(List, Duration)} with 30 seconds for each type. */
  public static EcoreChecks of(List<LoadedModel> models) {
    return of(models, TIME_LIMIT);
  }

  /**
   * Checks models that were loaded together.
   *
   * @param models at least one, all of one {@link XmiStore#loadAll}
   * @param timeLimit the processor time that the patterns of a data type may take on all of them;
   *     those of all types together may take four times as long
   */
  public static EcoreChecks of(List<LoadedModel> models, Duration timeLimit) {
    EcoreChecks checks = new EcoreChecks(models.get(0).origins()::locate, timeLimit);
    ProjectResources resources = (ProjectResources) models.get(0).resource().getResourceSet();
    Faults faults = new Faults(resources);
    for (LoadedModel model : models) {
      XmiResource file = (XmiResource) model.resource();
      DiagnosticException.runAt(file.place(), () -> faults.contentsOf(file).forEach(checks::check));
    }
    checks.found.addAll(faults.find());
    return checks.end();
  }

  /**
   * Checks a model in memory, with or without file. EMF itself ensures opposite ends and unique
   * values in memory; only files can violate them.
   *
   * @param locator returns the location of an element
   * @param timeLimit as in {@link #of(List, Duration)}
   */
  public static EcoreChecks of(
      EObject root, Function<EObject, SourceLocation> locator, Duration timeLimit) {
    EcoreChecks checks = new EcoreChecks(locator, timeLimit);
    checks.check(root);
    EcoreUtil.getAllProperContents(root, false)
        .forEachRemaining(element -> checks.check((EObject) element));
    return checks.end();
  }

  private EcoreChecks end() {
    for (Planned each : plans.values()) {
      count(EcoreRules.REQUIRED, each.instances * each.plan.required().size());
      count(EcoreRules.BOUND, each.instances * each.plan.bounded().size());
      count(EcoreRules.UNIQUE, each.instances * each.plan.unique().size());
      count(EcoreRules.OPPOSITE, each.instances * each.plan.paired().size());
    }
    found.addAll(values.findings());
    count(EcoreRules.VALUE, values.evaluations());
    found.sort(null);
    return this;
  }

  /** Returns the findings, in the order of files and lines. */
  public List<Diagnostic> diagnostics() {
    return List.copyOf(found);
  }

  /** Returns how often each check was applied; names neither files nor elements. */
  public Coverage coverage() {
    List<Coverage.Check> checks = new ArrayList<>();
    evaluations.forEach(
        (rule, times) ->
            checks.add(
                new Coverage.Check(
                    Coverage.Kind.METAMODEL,
                    rule.id(),
                    "",
                    rule.severity(),
                    SourceLocation.NONE,
                    "",
                    times)));
    return new Coverage(List.of(), 0, checks);
  }

  private void check(EObject element) {
    Planned planned = plans.computeIfAbsent(element.eClass(), Planned::of);
    planned.instances++;
    EcorePlan plan = planned.plan;
    plan.required().forEach(feature -> checkRequired(element, feature));
    plan.bounded().forEach(feature -> checkBound(element, feature));
    plan.values().forEach(attribute -> values.check(element, attribute));
    plan.keyed().forEach(reference -> checkKeys(element, reference));
    plan.maps().forEach(reference -> checkMap(element, reference));
  }

  private void count(Rule rule, long times) {
    evaluations.merge(rule, times, Long::sum);
  }

  private void report(Rule rule, EObject element, String message, String hint) {
    found.add(Diagnostic.of(rule, message, locator.apply(element)).withHint(hint));
  }

  /** Checks a feature as EMF does: a default is a value unless the feature is unsettable. */
  private void checkRequired(EObject element, EStructuralFeature feature) {
    if (feature.isMany()) {
      int size = ((List<?>) element.eGet(feature, false)).size();
      if (size < feature.getLowerBound()) {
        report(
            EcoreRules.REQUIRED,
            element,
            String.format(
                Locale.ROOT,
                "`%s` has %s, but needs %d.",
                feature.getName(),
                Coverage.counted(size, "value"),
                feature.getLowerBound()),
            "Add what is missing, or lower the feature's lowerBound.");
      }
    } else if (feature.isUnsettable()
        ? !element.eIsSet(feature)
        : element.eGet(feature, false) == null) {
      report(
          EcoreRules.REQUIRED,
          element,
          isContainer(feature)
              ? "The element is not part of a `%s`, but must be."
                  .formatted(feature.getEType().getName())
              : "`%s` has no value, but needs one.".formatted(feature.getName()),
          "Add what is missing, or declare the feature with lowerBound=\"0\".");
    }
  }

  private static boolean isContainer(EStructuralFeature feature) {
    return feature instanceof EReference reference && reference.isContainer();
  }

  private void checkBound(EObject element, EStructuralFeature feature) {
    int size = ((List<?>) element.eGet(feature, false)).size();
    if (size > feature.getUpperBound()) {
      report(
          EcoreRules.BOUND,
          element,
          String.format(
              Locale.ROOT,
              "`%s` has %s, but holds at most %d.",
              feature.getName(),
              Coverage.counted(size, "value"),
              feature.getUpperBound()),
          "Remove some, or raise the feature's upperBound.");
    }
  }

  private void checkKeys(EObject element, EReference reference) {
    Map<List<Object>, EObject> known = new HashMap<>();
    for (Object value : (List<?>) element.eGet(reference, true)) {
      EObject target = (EObject) value;
      List<Object> key = new ArrayList<>();
      reference.getEKeys().forEach(attribute -> key.add(target.eGet(attribute)));
      count(EcoreRules.KEY, 1);
      EObject first = known.putIfAbsent(key, target);
      if (first != null && first != target) {
        found.add(
            Diagnostic.of(
                    EcoreRules.KEY,
                    "Two elements of `%s` have the same key %s."
                        .formatted(reference.getName(), key),
                    locator.apply(target))
                .withRelated(locator.apply(first))
                .withHint("Give one of them another key: the metamodel tells them apart by it."));
      }
    }
  }

  private void checkMap(EObject element, EReference reference) {
    Map<Object, EObject> known = new HashMap<>();
    for (Object value : (List<?>) element.eGet(reference, true)) {
      EObject entry = (EObject) value;
      Object key = entry.eGet(entry.eClass().getEStructuralFeature("key"));
      count(EcoreRules.MAP, 1);
      EObject first = known.putIfAbsent(key, entry);
      if (first != null) {
        found.add(
            Diagnostic.of(
                    EcoreRules.MAP,
                    "The map `%s` has the key `%s` twice.".formatted(reference.getName(), key),
                    locator.apply(entry))
                .withRelated(locator.apply(first))
                .withHint("Keep one of the entries: a map has one value for each key."));
      }
    }
  }
}
