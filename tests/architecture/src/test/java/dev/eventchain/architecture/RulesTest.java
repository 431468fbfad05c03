package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.llm.chat.AnswerTrait;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Tests the constants that declare the rules of findings, and their agreement with the pages. */
@AnalyzeClasses(packages = "dev.eventchain", importOptions = DoNotIncludeTests.class)
class RulesTest {

  /** Reported by two bundles that do not know each other: the library, and what installs it. */
  private static final Set<String> DECLARED_TWICE = Set.of("dds.unavailable");

  @ArchTest
  static void eachRuleHasAPageAndEachPageARule(JavaClasses classes) throws Exception {
    List<Rule> rules = rules(classes);
    NavigableSet<String> pages =
        RulePage.all().stream().map(RulePage::id).collect(Collectors.toCollection(TreeSet::new));
    assertEquals(pages, ids(rules));
  }

  @ArchTest
  static void eachRuleIsDeclaredOnce(JavaClasses classes) throws Exception {
    Set<Rule> declared = Collections.newSetFromMap(new IdentityHashMap<>());
    declared.addAll(rules(classes)); // others are further names of the same constants
    Set<String> seen = new TreeSet<>();
    Set<String> again = new TreeSet<>();
    for (Rule rule : declared) {
      if (!seen.add(rule.id())) {
        again.add(rule.id());
      }
    }
    assertEquals(DECLARED_TWICE, again);
  }

  /** Files of suppressions are read without the code that reports the findings. */
  @ArchTest
  static void thePageSaysWhetherFindingsMayBeSuppressed(JavaClasses classes) throws Exception {
    List<String> disagreeing =
        rules(classes).stream()
            .filter(
                rule ->
                    rule.has(CommonTrait.UNSUPPRESSIBLE)
                        == RulePage.of(rule.id()).orElseThrow().mayBeSuppressed())
            .map(Rule::id)
            .toList();
    assertEquals(List.of(), disagreeing);
  }

  /**
   * A file that cannot be read was not checked; what is wrong with suppressions must not hide
   * itself.
   */
  @ArchTest
  static void whatHidesAMissingCheckCannotBeSuppressed(JavaClasses classes) throws Exception {
    NavigableSet<String> never =
        new TreeSet<>(
            Set.of(
                "campaign.inputs.changed",
                "eventchain.defect",
                "ocl.limit",
                "ocl.nothing-evaluated",
                "ocl.not-boolean",
                "ocl.type",
                "project.model.missing",
                "report.unwritable",
                "simulation.criterion.failed",
                "suppression.expired",
                "suppression.invalid",
                "suppression.stale"));
    List<Rule> rules = rules(classes);
    ids(rules).stream().filter(id -> id.endsWith(".syntax")).forEach(never::add);
    rules.removeIf(rule -> !rule.has(CommonTrait.UNSUPPRESSIBLE));
    assertEquals(never, ids(rules));
  }

  /** An error with this trait makes a verdict INCOMPLETE and not FAILED. */
  @ArchTest
  static void whatWasNotTestedIsKnown(JavaClasses classes) throws Exception {
    List<Rule> rules = rules(classes);
    rules.removeIf(rule -> !rule.has(CommonTrait.UNTESTED));
    assertEquals(
        new TreeSet<>(
            Set.of(
                "bench.field.unset",
                "bench.field.unwritten",
                "bench.topic.unconnected",
                "campaign.case.untested",
                "campaign.criterion.untested",
                "project.requirement.stale",
                "project.requirement.untested",
                "simulation.command.ignored",
                "simulation.criterion.untested",
                "simulation.end.open",
                "simulation.fault.no-effect",
                "simulation.fault.untested",
                "simulation.impact.unjudged",
                "simulation.latency.lower-bound",
                "simulation.latency.unmeasured",
                "simulation.node.silent",
                "simulation.not-repeatable",
                "simulation.output.range",
                "simulation.rule.untested",
                "simulation.strength.idle",
                "simulation.strength.low",
                "simulation.strength.none",
                "simulation.wire.unmatched")),
        ids(rules));
  }

  /** An evaluation must not blame a model for an answer that it was not asked for. */
  @ArchTest
  static void errorsOfCallsLeaveAnswersMissing(JavaClasses classes) throws Exception {
    List<Rule> rules = rules(classes);
    NavigableSet<String> unanswered =
        ids(rules.stream().filter(rule -> rule.has(AnswerTrait.UNANSWERED)).toList());
    rules.removeIf(rule -> !rule.id().startsWith("llm.") || rule.severity() != Severity.ERROR);
    assertEquals(ids(rules), unanswered);
  }

  /** Only ids that Python reports are looked up, and unknown ones among them kept as they are. */
  @ArchTest
  static void rulesAreConstants(JavaClasses classes) {
    Set<String> others =
        classes.stream()
            .flatMap(type -> type.getMethodCallsFromSelf().stream())
            .filter(call -> call.getTargetOwner().isEquivalentTo(Rule.class))
            .filter(call -> Set.of("error", "warning", "info").contains(call.getName()))
            .filter(call -> !call.getOrigin().getName().equals("<clinit>"))
            .map(call -> call.getOriginOwner().getSimpleName())
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(Set.of("ComponentRules", "HostFailures", "ResultBuilder"), others);
  }

  private static NavigableSet<String> ids(List<Rule> rules) {
    return rules.stream().map(Rule::id).collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns the values of all constants, including those in constants of enums. */
  private static List<Rule> rules(JavaClasses classes) throws Exception {
    List<Rule> rules = new ArrayList<>();
    for (JavaClass type : classes) {
      for (JavaField field : type.getFields()) {
        if (field.getRawType().isEquivalentTo(Rule.class)) {
          boolean constant = field.getModifiers().contains(JavaModifier.STATIC);
          if (constant || type.isEnum()) {
            addValues(Class.forName(type.getName()), field.getName(), constant, rules);
          }
        }
      }
    }
    assertTrue(rules.size() > 300, rules.toString());
    return rules;
  }

  private static void addValues(Class<?> type, String name, boolean constant, List<Rule> rules)
      throws Exception {
    Field field = type.getDeclaredField(name);
    field.setAccessible(true);
    if (constant) {
      rules.add((Rule) field.get(null));
      return;
    }
    for (Object each : type.getEnumConstants()) {
      rules.add((Rule) field.get(each));
    }
  }
}
