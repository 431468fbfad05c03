package dev.eventchain.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Tests the import directions of the bundles and the coding conventions. */
@AnalyzeClasses(packages = "dev.eventchain", importOptions = DoNotIncludeTests.class)
class ArchitectureTest {

  private static final String ROOT = "dev.eventchain.";

  private static final Path RECORD = Path.of("..", "..", "bundles", "decisions", "029-rooms.md");

  /** A program of the build, which starts the command line; it is part of no product. */
  private static final Optional<String> BUILDS_THE_SITE = Optional.of("documentation");

  private static final int TYPES_OF_A_PACKAGE = 40;

  /** A line of the record's table: {@code imported, bundles <- bundle}. */
  private static final Pattern IMPORTS = Pattern.compile("(?m)^ {4}([a-z0-9, ]+) <- ([a-z0-9]+)$");

  /** Each recorded import exists, and no other. */
  @ArchTest
  static void importsAreThoseOfTheRecord(JavaClasses classes) throws IOException {
    SortedMap<String, Set<String>> stated = new TreeMap<>();
    Matcher line = IMPORTS.matcher(Files.readString(RECORD));
    while (line.find()) {
      stated.put(line.group(2), new TreeSet<>(List.of(line.group(1).strip().split(", "))));
    }
    SortedMap<String, Set<String>> imports = new TreeMap<>();
    for (JavaClass type : classes) {
      Optional<String> bundle = bundleOf(type);
      bundle.ifPresent(
          name ->
              type.getDirectDependenciesFromSelf().stream()
                  .flatMap(dependency -> bundleOf(dependency.getTargetClass()).stream())
                  .filter(other -> !other.equals(name))
                  .forEach(
                      other -> imports.computeIfAbsent(name, n -> new TreeSet<>()).add(other)));
    }
    assertEquals(text(stated), text(imports));
  }

  private static String text(SortedMap<String, Set<String>> imports) {
    StringBuilder text = new StringBuilder();
    imports.forEach(
        (bundle, others) ->
            text.append(String.join(", ", others)).append(" <- ").append(bundle).append('\n'));
    return text.toString();
  }

  private static Optional<String> bundleOf(JavaClass type) {
    return type.getPackageName().startsWith(ROOT)
        ? Optional.of(type.getPackageName().substring(ROOT.length()).replaceFirst("\\..*", ""))
        : Optional.empty();
  }

  @ArchTest
  static final ArchRule BUNDLES_HAVE_NO_CYCLES =
      slices().matching(ROOT + "(*)..").should().beFreeOfCycles();

  /** EMF's generator creates a cycle in its code. */
  @ArchTest
  static final ArchRule PACKAGES_HAVE_NO_CYCLES =
      slices()
          .matching(ROOT + "(**)")
          .should()
          .beFreeOfCycles()
          .ignoreDependency(
              resideInAPackage(ROOT + "model.eventchain.."),
              resideInAPackage(ROOT + "model.eventchain.."));

  /** Checks that bundles export exactly the packages that others use. */
  @ArchTest
  static void bundlesUseWhatOthersExport(JavaClasses classes) throws IOException {
    Set<String> used = new TreeSet<>();
    for (JavaClass type : classes) {
      if (bundleOf(type).equals(BUILDS_THE_SITE)) {
        continue;
      }
      type.getDirectDependenciesFromSelf().stream()
          .map(dependency -> dependency.getTargetClass())
          .filter(target -> bundleOf(target).isPresent())
          .filter(target -> !bundleOf(target).equals(bundleOf(type)))
          .map(JavaClass::getPackageName)
          .forEach(used::add);
    }
    used.removeIf(name -> name.startsWith(ROOT + "model.eventchain"));
    assertEquals(used, Manifests.exportedPackages());
  }

  /** A package has a limited number of classes. */
  @ArchTest
  static void packagesAreSmall(JavaClasses classes) {
    SortedMap<String, Integer> sizes = new TreeMap<>();
    classes.stream()
        .filter(JavaClass::isTopLevelClass)
        .filter(type -> !type.getPackageName().startsWith(ROOT + "model.eventchain"))
        .forEach(type -> sizes.merge(type.getPackageName(), 1, Integer::sum));
    sizes.values().removeIf(size -> size <= TYPES_OF_A_PACKAGE);
    assertEquals(Map.of(), sizes);
  }

  @ArchTest
  static final ArchRule ONLY_THE_COMMAND_LINE_PRINTS_OR_EXITS =
      noClasses()
          .that()
          .resideOutsideOfPackages(ROOT + "cli..", ROOT + "emfgenerator..")
          .and()
          // It keeps from the terminal what a library prints there.
          .doNotHaveFullyQualifiedName(ROOT + "pipeline.diagram.DiagramImage")
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
  static final ArchRule LANGUAGES_KNOW_NO_EVENT_CHAIN =
      noClasses()
          .that()
          .resideInAnyPackage(
              ROOT + "diagnostics..",
              ROOT + "documents..",
              ROOT + "output..",
              ROOT + "editing..",
              ROOT + "ocl..",
              ROOT + "constraints..",
              ROOT + "m2t..",
              ROOT + "xmi..",
              ROOT + "jsonmodels..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              ROOT + "model..", ROOT + "description..", ROOT + "project..", ROOT + "messages..");

  /** Templates are read first, then linked and run: the reader does not depend on these steps. */
  @ArchTest
  static final ArchRule READING_TEMPLATES_KNOWS_NO_RUN =
      noClasses()
          .that(are(resideInAPackage(ROOT + "m2t.syntax..")))
          .should()
          .dependOnClassesThat(
              resideInAPackage(ROOT + "m2t..").and(not(resideInAPackage(ROOT + "m2t.syntax.."))))
          .orShould()
          .dependOnClassesThat()
          .resideInAnyPackage(ROOT + "ocl..", "org.eclipse.emf..");

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
          .resideOutsideOfPackage(ROOT + "model.eventchain..")
          .and()
          .areDeclaredInClassesThat() // JNA finds the fields of C structures by reflection
          .areNotAssignableTo("com.sun.jna.Structure")
          .and()
          .areNotStatic()
          .should()
          .notBePublic();
}
