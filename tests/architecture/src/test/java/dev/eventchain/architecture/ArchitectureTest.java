package dev.eventchain.architecture;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The import directions of decision 001, and the habits that a machine can hold. */
@AnalyzeClasses(packages = "dev.eventchain", importOptions = DoNotIncludeTests.class)
class ArchitectureTest {

  private static final String ROOT = "dev.eventchain.";

  /** What each bundle may import besides diagnostics, directly or through another. */
  private static final Map<String, Set<String>> IMPORTS =
      Map.ofEntries(
          Map.entry("diagnostics", Set.of()),
          Map.entry("metamodel", Set.of()),
          Map.entry("ocl", Set.of()),
          Map.entry("messages", Set.of()),
          Map.entry("python", Set.of()),
          Map.entry("llm", Set.of()),
          Map.entry("m2t", Set.of("ocl")),
          Map.entry("modeler", Set.of("metamodel")),
          Map.entry("analysis", Set.of("metamodel", "messages")),
          Map.entry("simulation", Set.of("metamodel", "messages", "python")),
          Map.entry(
              "agents",
              Set.of("ocl", "analysis", "messages", "modeler", "metamodel", "python", "llm")),
          Map.entry(
              "pipeline",
              Set.of(
                  "metamodel",
                  "ocl",
                  "messages",
                  "python",
                  "llm",
                  "m2t",
                  "modeler",
                  "analysis",
                  "simulation",
                  "agents")),
          Map.entry("cli", Set.of("pipeline")));

  @ArchTest
  static void importsGoOneWayOnly(JavaClasses classes) {
    for (Map.Entry<String, Set<String>> bundle : IMPORTS.entrySet()) {
      Set<String> allowed = new TreeSet<>(bundle.getValue());
      allowed.add("diagnostics");
      allowed.add(bundle.getKey());
      String[] forbidden =
          IMPORTS.keySet().stream()
              .filter(other -> !allowed.contains(other))
              .sorted()
              .map(other -> ROOT + other + "..")
              .toArray(String[]::new);
      noClasses()
          .that()
          .resideInAPackage(ROOT + bundle.getKey() + "..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(forbidden)
          .check(classes);
    }
  }

  @ArchTest
  static void everyBundleIsInTheTable(JavaClasses classes) {
    Set<String> bundles =
        classes.stream()
            .map(JavaClass::getPackageName)
            .filter(name -> name.startsWith(ROOT))
            .map(name -> name.substring(ROOT.length()).replaceFirst("\\..*", ""))
            .filter(name -> !name.equals("architecture"))
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(new TreeSet<>(IMPORTS.keySet()), bundles);
  }

  @ArchTest
  static final ArchRule BUNDLES_HAVE_NO_CYCLES =
      slices().matching(ROOT + "(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule ONLY_THE_COMMAND_LINE_PRINTS_OR_EXITS =
      noClasses()
          .that()
          .resideOutsideOfPackages(ROOT + "cli..", ROOT + "metamodel.generator..")
          .should()
          .accessField(System.class, "out")
          .orShould()
          .accessField(System.class, "err")
          .orShould()
          .callMethod(System.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "halt", int.class)
          .orShould()
          .callMethod(Throwable.class, "printStackTrace");

  @ArchTest
  static final ArchRule OCL_AND_TEMPLATES_KNOW_NO_EVENT_CHAIN =
      noClasses()
          .that(are(resideInAPackage(ROOT + "ocl..")).or(resideInAPackage(ROOT + "m2t..")))
          .should()
          .dependOnClassesThat()
          .resideInAPackage(ROOT + "metamodel..");

  @ArchTest
  static final ArchRule NO_BUNDLE_OPENS_HTTP_BUT_LLM =
      noClasses()
          .that()
          .resideOutsideOfPackage(ROOT + "llm..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.net.http..");

  @ArchTest
  static final ArchRule FIELDS_OF_PUBLIC_TYPES_ARE_NOT_PUBLIC =
      com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields()
          .that()
          .areDeclaredInClassesThat()
          .resideOutsideOfPackage(ROOT + "metamodel.eventchain..")
          .and()
          .areNotStatic()
          .should()
          .notBePublic();

  /** Decision 001: a bundle is deep, with few types that others see. */
  @ArchTest
  static void bundlesShowFewTypes(JavaClasses classes) {
    int most = 12;
    List<String> wide = new ArrayList<>();
    for (String bundle : IMPORTS.keySet()) {
      Stream<JavaClass> visible =
          classes.stream()
              .filter(type -> type.getPackageName().equals(ROOT + bundle))
              .filter(type -> type.getModifiers().contains(JavaModifier.PUBLIC))
              .filter(JavaClass::isTopLevelClass);
      long count = visible.count();
      if (count > most) {
        wide.add(bundle + " shows " + count);
      }
    }
    assertEquals(List.of(), wide);
  }
}
