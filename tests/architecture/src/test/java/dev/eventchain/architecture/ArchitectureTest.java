package dev.eventchain.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
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
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The import directions of the bundles, and the habits that a machine can hold. */
@AnalyzeClasses(packages = "dev.eventchain", importOptions = DoNotIncludeTests.class)
class ArchitectureTest {

  private static final String ROOT = "dev.eventchain.";

  private static final Path RECORD =
      Path.of("..", "..", "bundles", "decisions", "012-one-of-each.md");

  /** A line of the record's table: {@code imported, bundles <- bundle}. */
  private static final Pattern IMPORTS = Pattern.compile("(?m)^ {4}([a-z0-9, ]+) <- ([a-z0-9]+)$");

  /** How many types each bundle shows; a number may be lowered. */
  private static final Map<String, Integer> PUBLIC_TYPES =
      new TreeMap<>(
          Map.ofEntries(
              Map.entry("diagnostics", 14),
              Map.entry("documents", 7),
              Map.entry("metamodel", 8),
              Map.entry("ocl", 14),
              Map.entry("rules", 4),
              Map.entry("messages", 8),
              Map.entry("dds", 6),
              Map.entry("python", 9),
              Map.entry("llm", 11),
              Map.entry("m2t", 4),
              Map.entry("output", 3),
              Map.entry("modeler", 10),
              Map.entry("analysis", 2),
              Map.entry("simulation", 11),
              Map.entry("agents", 9),
              Map.entry("templates", 1),
              Map.entry("validation", 9),
              Map.entry("pipeline", 18),
              Map.entry("cli", 1),
              Map.entry("documentation", 1),
              Map.entry("maven", 6)));

  /** Each import that the record states exists, and no other. */
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

  /** What is shown there is what Java starts. */
  private static final Set<String> PROGRAMS =
      Set.of(ROOT + "cli", ROOT + "documentation", ROOT + "maven");

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
  static final ArchRule LANGUAGES_KNOW_NO_EVENT_CHAIN =
      noClasses()
          .that()
          .resideInAnyPackage(ROOT + "ocl..", ROOT + "rules..", ROOT + "m2t..", ROOT + "output..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage(ROOT + "metamodel..");

  /** Templates are read first, then linked and run: what reads them knows nothing of that. */
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
          .resideOutsideOfPackage(ROOT + "metamodel.eventchain..")
          .and()
          .areDeclaredInClassesThat() // JNA finds the fields of C's structures by reflection
          .areNotAssignableTo("com.sun.jna.Structure")
          .and()
          .areNotStatic()
          .should()
          .notBePublic();

  /** A bundle is deep: it shows few types, and none that no other bundle needs. */
  @ArchTest
  static void bundlesShowNoMoreTypesThanBefore(JavaClasses classes) {
    SortedMap<String, Integer> shown = new TreeMap<>();
    shownTypes(classes).forEach(type -> shown.merge(bundleOf(type).orElseThrow(), 1, Integer::sum));
    assertEquals(PUBLIC_TYPES, shown);
  }

  @ArchTest
  static void everyTypeThatIsShownIsNeeded(JavaClasses classes) {
    Set<String> unneeded =
        shownTypes(classes)
            .filter(type -> !PROGRAMS.contains(type.getPackageName()))
            .filter(type -> !type.getSimpleName().equals("DdsEvent")) // no driver asks for it yet
            .filter(type -> !type.getSimpleName().equals("ProjectValidation")) // editors ask for it
            .filter(
                type -> !type.getSimpleName().equals("ExitCode")) // its constants are compiled in
            .filter(type -> !isNeededElsewhere(type))
            .map(JavaClass::getName)
            .collect(Collectors.toSet());
    assertEquals(Set.of(), unneeded);
  }

  /** What is generated is in its own package, and is not counted. */
  private static Stream<JavaClass> shownTypes(JavaClasses classes) {
    return classes.stream()
        .filter(
            type ->
                bundleOf(type).map(ROOT::concat).stream().anyMatch(type.getPackageName()::equals))
        .filter(type -> type.getModifiers().contains(JavaModifier.PUBLIC))
        .filter(JavaClass::isTopLevelClass);
  }

  private static boolean isNeededElsewhere(JavaClass type) {
    return type.getDirectDependenciesToSelf().stream()
        .anyMatch(dependency -> !bundleOf(dependency.getOriginClass()).equals(bundleOf(type)));
  }
}
