package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.output.OutputFolder.OnEdit;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.tools.ToolProvider;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EObject;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which methods templates can call, and the findings about those that fail. */
class JavaServicesTest {

  private static final String ECORE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shop" nsURI="http://example.org/shop" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Shop">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="name" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
          <eStructuralFeatures xsi:type="ecore:EReference" name="branches" upperBound="-1" eType="#//Shop" containment="true"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  private static final String MODEL =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <shop:Shop xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:shop="http://example.org/shop" name="bakery">
        <branches name="north"/>
        <branches name="south"/>
      </shop:Shop>
      """;

  private static final String TEMPLATE =
      """
      [module main('http://example.org/shop')]
      [template public main(shop : Shop) ? (shop.name = 'bakery')]
      [comment @main /]
      [file ('out.txt', false)]
      BODY
      [/file]
      [/template]
      """;

  /** The last initialised class that the test can observe. */
  private static final String INITIALISED = "dev.eventchain.test.initialised";

  /** A class of this program that templates must not initialise. */
  static final class Sleeper {
    static {
      System.setProperty(INITIALISED, "Sleeper");
    }

    private Sleeper() {}

    public static String wake() {
      return "awake";
    }
  }

  @TempDir Path folder;
  private Path classes;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("shop.ecore"), ECORE);
    Files.writeString(folder.resolve("model.xmi"), MODEL);
    classes = Files.createDirectories(folder.resolve("classes"));
  }

  @AfterEach
  void forget() {
    System.clearProperty(INITIALISED);
  }

  /** Compiles public classes of the package demo, given as names each followed by its source. */
  private void compile(String... sources) throws IOException {
    Path place = Files.createDirectories(folder.resolve("src/demo"));
    List<String> arguments =
        new ArrayList<>(List.of("-proc:none", "-Xlint:none", "-d", classes.toString()));
    String libraries = library(EObject.class) + File.pathSeparator + library(EList.class);
    arguments.addAll(List.of("-classpath", libraries));
    for (String source : sources) {
      String name = source.replaceFirst("(?s).*?public (?:abstract )?class (\\w+).*", "$1");
      Path file = Files.writeString(place.resolve(name + ".java"), "package demo;\n" + source);
      arguments.add(file.toString());
    }
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, arguments.toArray(String[]::new));
    assertEquals(0, failed);
  }

  /** Returns the JAR that a class is in. */
  private static Path library(Class<?> type) {
    return Path.of(URI.create(type.getProtectionDomain().getCodeSource().getLocation().toString()));
  }

  private List<Diagnostic> generate(String body) throws IOException {
    Path template = Files.writeString(folder.resolve("main.mtl"), TEMPLATE.replace("BODY", body));
    return AnyModel.generate(
            new ModelFiles(
                List.of(folder.resolve("model.xmi")),
                List.of(folder.resolve("shop.ecore")),
                ReferenceFolders.NONE),
            new AnyModel.Template(template, List.of(), List.of(classes), List.of()),
            new AnyModel.Target(
                Optional.of(folder.resolve("out")), OnEdit.KEEP, false, Optional.empty()),
            new AnyModel.Check(false, Suppressions.NONE, Duration.ofSeconds(30)))
        .diagnostics();
  }

  private String output(String body) throws IOException {
    assertEquals(List.of(), generate(body));
    return Files.readString(folder.resolve("out/out.txt"));
  }

  private static String call(String className, String signature) {
    return "[invoke('" + className + "', '" + signature + "', Sequence{})/]";
  }

  /** Returns the reason in the one finding of a body. */
  private String refused(String body) throws IOException {
    List<Diagnostic> found = generate(body);
    assertEquals(List.of("m2t.service"), found.stream().map(Diagnostic::id).toList());
    Diagnostic finding = found.get(0);
    assertEquals(5, finding.location().line());
    return finding.message().replaceFirst("(?s).*\\(the Java service (.*)\\)\\..*", "$1");
  }

  @Test
  void aMethodThatAClassInheritsFromTheJavaLibraryIsAbsent() throws IOException {
    compile("public class Worker extends Thread { public String work() { return \"done\"; } }");
    assertEquals("done\n", output(call("demo.Worker", "work()")));
    for (String inherited : List.of("getAllStackTraces()", "getClass()", "start()", "hashCode()")) {
      assertEquals(
          "'demo.Worker." + inherited + "' is absent: its class has no such public method",
          refused(call("demo.Worker", inherited)));
    }
  }

  @Test
  void aMethodThatAClassInheritsFromAnotherServiceIsThere() throws IOException {
    compile(
        "public class Baker extends Person {}",
        "class Named { public String name() { return \"Anna\"; } }\n"
            + "public class Person extends Named {}");
    assertEquals("Anna\n", output(call("demo.Baker", "name()")));
  }

  @Test
  void aClassOfTheProgramIsNoServiceAndStaysUninitialised() throws IOException {
    String name = Sleeper.class.getName();
    String reason = refused(call(name, "wake()"));
    assertTrue(reason.contains("is not a service"), reason);
    assertEquals(null, System.getProperty(INITIALISED));
    assertEquals("awake", Sleeper.wake());
    assertEquals("Sleeper", System.getProperty(INITIALISED));
  }

  @Test
  void aClassThatTheProgramHasTooIsTheProgramsAndNoService() throws IOException {
    Path copy = classes.resolve(Sleeper.class.getName().replace('.', '/') + ".class");
    Files.createDirectories(copy.getParent());
    try (var original = Sleeper.class.getResourceAsStream("JavaServicesTest$Sleeper.class")) {
      Files.copy(original, copy);
    }
    String reason = refused(call(Sleeper.class.getName(), "wake()"));
    assertTrue(reason.contains("is not a service"), reason);
    assertEquals(null, System.getProperty(INITIALISED));
  }

  @Test
  void namesThatAreNoneOfClassesAreAbsent() throws IOException {
    compile("public class Words { public static String word() { return \"w\"; } }");
    for (String name : List.of("[Ldemo.Words;", "demo/Words", "../classes/demo.Words", "", "int")) {
      String reason = refused(call(name, "word()"));
      assertEquals("'" + name + ".word()' is missing: the services have no such class", reason);
    }
  }

  @Test
  void aClassThatLacksALibraryIsNamed() throws IOException {
    String source =
        """
        public class User {
          public static String fine() { return "fine"; }
          public static String use(Library library) { return "used"; }
        }
        """;
    compile("public class Library {}", source);
    Files.delete(classes.resolve("demo/Library.class"));
    assertEquals(
        "'demo.User.fine()' needs the class 'demo.Library', which could not be loaded",
        refused(call("demo.User", "fine()")));
  }

  @Test
  void aClassThatCannotBeInitialisedSaysWhy() throws IOException {
    String source =
        """
        public class Broken {
          static final int SIZE = Integer.parseInt("many");
          public static String size() { return "" + SIZE; }
        }
        """;
    compile(source);
    assertEquals(
        "'demo.Broken.size()' threw java.lang.NumberFormatException: For input string: \"many\""
            + " (Broken.java:3)",
        refused(call("demo.Broken", "size()")));
  }

  @Test
  void anExceptionWhoseMessageThrowsIsNamedWithoutIt() throws IOException {
    String source =
        """
        public class Evil extends RuntimeException {
          public String getMessage() { throw new Evil(); }
          public static String fail() { throw new Evil(); }
        }
        """;
    compile(source);
    assertEquals(
        "'demo.Evil.fail()' threw demo.Evil (Evil.java:4)", refused(call("demo.Evil", "fail()")));
  }

  @Test
  void anObjectIsWrittenAsItsTextAndRefusedIfThatFails() throws IOException {
    String source =
        """
        public class Money {
          public static Object some() { return new Money(); }
          public static Object[] other() { return new Object[] {new Other()}; }
          public static Object plain() { return new Object(); }
          public String toString() { return "5 euros"; }
          static class Other {
            public String toString() { throw new IllegalStateException("no text"); }
          }
        }
        """;
    compile(source);
    assertEquals("5 euros\n", output(call("demo.Money", "some()")));
    assertEquals(
        "'demo.Money.other()' threw java.lang.IllegalStateException: no text" + " (Money.java:8)",
        refused(call("demo.Money", "other()")));
    assertEquals(
        "'demo.Money.plain()' gives a java.lang.Object, which has no text",
        refused(call("demo.Money", "plain()")));
  }

  @Test
  void theTypesOfAnotherMethodAreShownAsJavaWritesThem() throws IOException {
    String source =
        """
        public class Words {
          public static String all(String[] words, int[][] n) { return ""; }
        }
        """;
    compile(source);
    assertEquals(
        "'demo.Words.all()' is absent: there is only all(java.lang.String[], int[][])",
        refused(call("demo.Words", "all()")));
  }

  @Test
  void aMethodWithAnyNumberOfArgumentsIsRefused() throws IOException {
    compile("public class Words { public static String all(String... words) { return \"\"; } }");
    for (String signature : List.of("all(String[])", "all(java.lang.String...)")) {
      assertEquals(
          "'demo.Words."
              + signature
              + "' takes any number of arguments, which templates cannot pass: make it take a List",
          refused(call("demo.Words", signature)));
    }
  }

  @Test
  void anAbstractClassHasNoInstanceButStaticMethods() throws IOException {
    String source =
        """
        public abstract class Shape {
          public String name() { return "shape"; }
          public static String kind() { return "kind"; }
        }
        """;
    compile(source);
    assertEquals("kind\n", output(call("demo.Shape", "kind()")));
    assertEquals(
        "'demo.Shape.name()' needs an instance of its class, which is abstract: make the method"
            + " static",
        refused(call("demo.Shape", "name()")));
  }

  @Test
  void aClassOfANewerJavaSaysSo() throws IOException {
    compile("public class Words { public static String word() { return \"w\"; } }");
    Path file = classes.resolve("demo/Words.class");
    byte[] bytes = Files.readAllBytes(file);
    bytes[6] = 1; // the class file's major version, far beyond any
    Files.write(file, bytes);
    assertEquals(
        "'demo.Words.word()' is compiled for a newer Java than " + Runtime.version().feature(),
        refused(call("demo.Words", "word()")));
  }

  @Test
  void theSignatureTellsMethodsOfOneNameApart() throws IOException {
    String source =
        """
        import java.util.List;
        import org.eclipse.emf.ecore.EClass;
        import org.eclipse.emf.ecore.EObject;
        public class Kinds {
          public static String kind(EObject object) { return "object "; }
          public static String kind(EClass type) { return "class " + type.getName() + " "; }
          public static String kind(List<EObject> all) { return "list of " + all.size() + " "; }
          public static String kind(Object any, String text) { return any + text; }
        }
        """;
    compile(source);
    assertEquals(
        "object class Shop list of 2 null!\n",
        output(
            kind("EObject", "self")
                + kind("org.eclipse.emf.ecore.EClass", "self.eClass()")
                + kind("java.util.List<EObject>", "self.branches")
                + kind("Object, String", "null, '!'")));
  }

  private static String kind(String types, String arguments) {
    return "[invoke('demo.Kinds', 'kind(" + types + ")', Sequence{" + arguments + "})/]";
  }

  @Test
  void everyRunHasAnInstanceOfItsOwn() throws IOException {
    String source =
        """
        public class Counter {
          private long calls;
          public long count() { return ++calls; }
        }
        """;
    compile(source);
    String twice = call("demo.Counter", "count()").repeat(2);
    assertEquals("12\n", output(twice));
    assertEquals("12\n", output(twice));
  }

  @Test
  void aServiceMayAddToTheListThatALoopWalksThrough() throws IOException {
    String source =
        """
        import org.eclipse.emf.ecore.EObject;
        import org.eclipse.emf.ecore.util.EcoreUtil;
        public class Garden {
          @SuppressWarnings("unchecked")
          public static int grow(EObject plant) {
            var plants = (java.util.List<EObject>)
                plant.eContainer().eGet(plant.eContainingFeature());
            plants.add(EcoreUtil.copy(plant));
            return plants.size();
          }
        }
        """;
    compile(source);
    String grow = "[invoke('demo.Garden', 'grow(org.eclipse.emf.ecore.EObject)', Sequence{b})/]";
    assertEquals(
        "north3 south4 4\n",
        output(
            "[for (b : Shop | shop.branches)][b.name/]"
                + grow
                + " [/for][shop.branches->size()/]"));
  }
}
