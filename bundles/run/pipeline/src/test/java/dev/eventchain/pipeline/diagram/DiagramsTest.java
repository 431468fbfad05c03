package dev.eventchain.pipeline.diagram;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.diagram.Diagrams.Kind;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DiagramsTest {

  /**
   * Texts that could act as directives, variables, comments, Creole or markup, or be misleading.
   */
  private static final List<String> HOSTILE =
      List.of(
          "!include /etc/passwd",
          "a\n!include /etc/passwd\n@enduml\n@startuml",
          "\" as x\n!includeurl http://example.org/x.puml\nstate \"",
          "%date() %getenv(\"HOME\") $variable ${x}",
          "**bold** //italic// __under__ --strike-- ~~wave~~ \"\"mono\"\"",
          "<img:/etc/passwd> <img src=\"http://example.org/x.png\"> <&bolt> <$sprite>",
          "<b>b</b><script>alert(1)</script></text></svg>",
          "[[javascript:alert(1) click]] [[http://example.org]]",
          "\\n \\t \\\\ <U+0041> &#65; &lt; &amp;lt;",
          "' comment /' block '/ }",
          "}\nskinparam backgroundColor red\n{",
          "= heading | cell | #red; :action; ->x--> <|-- *-- ..> (y)",
          "- # + ~ {static} {abstract} <<stereotype>>",
          "--",
          "..",
          "==",
          "__",
          "-",
          "*",
          "|=x|",
          "::",
          "<:smile:>",
          "<math>x</math> <latex>x</latex>",
          "\u202egnp.exe \u200b \ue000 \u0085",
          "über 漢字 🚗");

  private static final String DECLARATION = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";

  @TempDir Path folder;

  @Test
  void activityShowsComponentsTopicsAndTypesInOrder() throws IOException {
    EventChain chain = chain();
    SoftwareNode first = node(chain, "Detection", "/lidar", "/scan");
    first.setFrequency(20);
    node(chain, "Decision", "/scan", "/brake");

    String text = drawn(chain, Kind.ACTIVITY);

    assertTrue(
        text.endsWith(
            """
            state "/lidar\\n<size:11><color:#5B6770>std_msgs/msg/Float32" as t1 <<topic>>
            state "/scan\\n<size:11><color:#5B6770>std_msgs/msg/Float32" as t2 <<topic>>
            state "/brake\\n<size:11><color:#5B6770>std_msgs/msg/Float32" as t3 <<topic>>
            state "Detection\\n<size:12><color:#39434B>existing,\u00a020\u00a0Hz" as n1 <<existing>>
            state "Decision\\n<size:12><color:#39434B>existing" as n2 <<existing>>
            [*] --> t1
            t1 --> n1
            t2 --> n2
            n1 --> t2
            n2 --> t3
            t3 --> [*]
            @enduml
            """),
        text);
    List<String> shown = Pictures.texts(svg(Kind.ACTIVITY));
    assertTrue(
        shown.containsAll(List.of("Detection", "/scan", "std_msgs/msg/Float32")), shown::toString);
  }

  @Test
  void barsForkAndJoinAndTheirArrowsTouchThem() throws IOException {
    String text = drawn(forkAndJoin(), Kind.ACTIVITY);

    assertTrue(text.contains("state f2 <<fork>>\nt2 --> f2\nf2 --> n2\nf2 --> n3\n"), text);
    assertTrue(text.contains("state j4 <<join>>\nj4 --> n4\n"), text);
    String svg = svg(Kind.ACTIVITY);
    List<MatchResult> bars =
        Pictures.matches(
            "<rect x=\"(\\d+)\" y=\"(\\d+)\" width=\"(\\d+)\" height=\"4\" rx=\"0\"", svg);
    assertEquals(2, bars.size());
    for (MatchResult bar : bars) {
      String bottom = String.valueOf(Integer.parseInt(bar.group(2)) + 4);
      String line = "d=\"M\\d+ (" + bottom + " V?|.*[ L]\\d+ " + bar.group(2) + "\")";
      assertTrue(Pictures.matches(line, svg).size() > 0, () -> "nothing touches the bar " + bar);
    }
  }

  @Test
  void circlesAreDrawnWithoutAStart() throws IOException {
    EventChain chain = chain();
    node(chain, "A", "/b", "/a");
    node(chain, "B", "/a", "/b");

    assertFalse(drawn(chain, Kind.ACTIVITY).contains("[*]"));
    assertTrue(Pictures.texts(svg(Kind.ACTIVITY)).containsAll(List.of("A", "B")));
  }

  @Test
  void hostileNamesComeOutAsText() throws Exception {
    EventChain hostile = chain();
    EventChain harmless = chain();
    for (int index = 0; index < HOSTILE.size(); index++) {
      SoftwareNode node = node(hostile, HOSTILE.get(index), "/t" + index, "/t" + (index + 1));
      node.setDescription(HOSTILE.get(index));
      node(harmless, "x", "/t" + index, "/t" + (index + 1)).setDescription("x");
    }
    for (Kind kind : EnumSet.of(Kind.ACTIVITY, Kind.INSTANCE)) {
      String text = drawn(hostile, kind);
      List<String> shown =
          kind == Kind.ACTIVITY ? Pictures.titles(svg(kind)) : Pictures.texts(svg(kind));
      Set<String> shape = Pictures.shape(svg(kind));

      assertEquals(
          Pictures.lines(drawn(harmless, kind)),
          Pictures.lines(text),
          "the same lines but for the names");
      assertEquals(Pictures.shape(svg(kind)), shape, "the same elements");
      for (String name : HOSTILE) {
        String expected =
            kind == Kind.ACTIVITY
                ? Printable.clean(name).replace('\n', ' ').replaceAll("\\p{C}", "\ufffd")
                : name.replaceAll("[\\p{Cc}\\s]+", " ").trim().replaceAll("\\p{C}", "\ufffd");
        assertTrue(
            shown.stream().anyMatch(each -> each.contains(expected)),
            () -> expected + " is not in " + shown);
      }
    }
  }

  @Test
  void longNamesAreShortened() throws IOException {
    EventChain chain = chain();
    node(chain, "a".repeat(4095) + "!", "/" + "b/".repeat(2000), "/c");

    drawn(chain, Kind.ACTIVITY);

    List<String> shown = Pictures.texts(svg(Kind.ACTIVITY));
    assertTrue(shown.stream().anyMatch(each -> each.matches("a{9,}…a{9,}!")), shown::toString);
  }

  @Test
  void hostileMetamodelComesOutAsText() throws Exception {
    Path ecore =
        Files.writeString(
            folder.resolve("hostile.ecore"),
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="p" nsURI="http://example.org/&#xA;!include x" nsPrefix="p">
              <eClassifiers xsi:type="ecore:EClass" name="&lt;img:/etc/passwd>">
                <eStructuralFeatures xsi:type="ecore:EAttribute" name="}&#xA;@enduml" eType="#//E"/>
                <eStructuralFeatures xsi:type="ecore:EReference" name="[[http://x]]" upperBound="-1" eType="#//%3Cimg:%2Fetc%2Fpasswd%3E" containment="true"/>
              </eClassifiers>
              <eClassifiers xsi:type="ecore:EEnum" name="E"><eLiterals name="%date()"/></eClassifiers>
            </ecore:EPackage>
            """
                .replace(
                    "eType=\"#//%3Cimg:%2Fetc%2Fpasswd%3E\"", "eType=\"#/0/@eClassifiers.0\""));

    List<Diagnostic> found =
        Diagrams.draw(
                EnumSet.of(Kind.METAMODEL),
                ModelFiles.of(List.of(), List.of(ecore)),
                folder.resolve("out"),
                OnEdit.KEEP)
            .diagnostics();

    assertEquals(List.of(), found);
    List<String> shown = Pictures.texts(svg(Kind.METAMODEL));
    assertTrue(
        shown.containsAll(List.of("<img:/etc/passwd>", "} @enduml : E", "[[http://x]]", "%date()")),
        shown::toString);
    Pictures.shape(svg(Kind.METAMODEL));
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void sameModelGivesSameBytesAndLeavesFilesAlone(Kind kind) throws IOException {
    drawn(forkAndJoin(), kind);
    byte[] first = Files.readAllBytes(folder.resolve("out/" + kind + ".svg"));
    FileTime past = FileTime.fromMillis(1_000_000_000);
    for (String end : List.of(".puml", ".svg")) {
      Files.setLastModifiedTime(folder.resolve("out/" + kind + end), past);
    }

    drawn(forkAndJoin(), kind);

    for (String end : List.of(".puml", ".svg")) {
      assertEquals(past, Files.getLastModifiedTime(folder.resolve("out/" + kind + end)));
    }
    String svg = new String(first, StandardCharsets.UTF_8).replace(DECLARATION, "");
    assertFalse(svg.contains("<?") || svg.contains("plantuml"), "no version, no source");
  }

  @Test
  void smallPartsStandInsideTheirElement() throws IOException {
    EventChain chain = chain();
    node(chain, "A", "/a", "/b");
    QosProfile qos = EventchainFactory.eINSTANCE.createQosProfile();
    qos.setName("sensor_data");
    qos.setDepth(5);
    chain.getData().get(0).setQos(qos);

    String text = drawn(chain, Kind.INSTANCE);

    assertTrue(
        text.contains(
            "qos = sensor_data : QosProfile (depth = 5)"
                .replace(' ', '\u00a0')
                .replace("(", "&#40;")
                .replace(")", "&#41;")),
        text);
    assertFalse(text.contains("o1 *--"), "that the root holds it goes without saying: " + text);
    assertTrue(text.contains("o2 --> o3 : input"), text);
    assertEquals(4, Pictures.matches("(?m)^object ", text).size());
  }

  /** Measurements have no name. */
  @Test
  void elementsWithoutANameAreDrawnUnderTheirClass() throws IOException {
    EventchainFactory factory = EventchainFactory.eINSTANCE;
    EventChain chain = chain();
    SoftwareNode node = node(chain, "A", "/a", "/b");
    node.setMeasured(factory.createNodeMeasurement());
    node.getMeasured().setActivations(7);
    ChainMeasurement scenario = factory.createChainMeasurement();
    scenario.setLatency(factory.createStatistics());
    scenario.getLatency().setCount(3);
    scenario.getMeasurements().add(factory.createMeasurement());
    scenario.getMeasurements().get(0).setName("gap");
    scenario.getMeasurements().get(0).setUnit("m");
    chain.getMeasured().add(scenario);

    String text = drawn(chain, Kind.INSTANCE).replace('\u00a0', ' ');

    assertTrue(text.contains("object \"<u>: ChainMeasurement</u>\""), text);
    assertTrue(text.contains("latency = : Statistics &#40;count = 3&#41;"), text);
    assertTrue(text.contains("measurements = gap : Measurement &#40;unit = m&#41;"), text);
    assertTrue(text.contains("measured = : NodeMeasurement &#40;activations = 7&#41;"), text);
  }

  @Test
  void modelWithoutAChainHasNoActivityDiagram() throws IOException {
    List<Diagnostic> found = draw(chain(), EnumSet.of(Kind.ACTIVITY));

    assertEquals(List.of("diagram.nothing"), found.stream().map(Diagnostic::id).toList());
    assertFalse(Files.exists(folder.resolve("out/activity.svg")));
  }

  @Test
  void modelOfAThousandNodesIsRefused() throws IOException {
    EventChain chain = chain();
    for (int index = 0; index < 1000; index++) {
      node(chain, "N" + index, "/t" + index, "/t" + (index + 1));
    }

    List<Diagnostic> found = draw(chain, EnumSet.allOf(Kind.class));

    assertEquals(
        List.of("diagram.too-large", "diagram.too-large"),
        found.stream().map(Diagnostic::id).toList());
    // 1,000 components and 1,001 topics, one arrow into and out of each, one from the start and one
    // to the end.
    assertEquals(
        "The activity diagram has 4003 boxes and arrows; at most 1000 are drawn.",
        found.get(0).message());
    assertTrue(Files.exists(folder.resolve("out/metamodel.svg")));
  }

  @Test
  void attributesAreNeitherBoxesNorArrows() throws IOException {
    StringBuilder ecore = new StringBuilder();
    ecore.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ecore:EPackage xmi:version=\"2.0\"");
    ecore.append(" xmlns:xmi=\"http://www.omg.org/XMI\"");
    ecore.append(" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"");
    ecore.append(" xmlns:ecore=\"http://www.eclipse.org/emf/2002/Ecore\"");
    ecore.append(" name=\"p\" nsURI=\"http://example.org/p\" nsPrefix=\"p\">\n");
    for (int i = 0; i < 30; i++) {
      ecore.append("<eClassifiers xsi:type=\"ecore:EClass\" name=\"C").append(i).append("\">\n");
      for (int j = 0; j < 40; j++) {
        ecore.append("<eStructuralFeatures xsi:type=\"ecore:EAttribute\" name=\"a").append(j);
        ecore.append(
            "\" eType=\"ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EInt\"/>\n");
      }
      ecore.append("</eClassifiers>\n");
    }
    Path file = Files.writeString(folder.resolve("p.ecore"), ecore.append("</ecore:EPackage>\n"));

    WrittenFiles files =
        Diagrams.draw(
            EnumSet.of(Kind.METAMODEL),
            ModelFiles.of(List.of(), List.of(file)),
            folder.resolve("out"),
            OnEdit.KEEP);

    assertEquals(List.of(), files.diagnostics());
    assertTrue(files.summary().endsWith("2 written"), files.summary());
  }

  private static EventChain chain() {
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    chain.setName("test");
    return chain;
  }

  /**
   * Returns a chain in which two components read the same topic, and a fourth reads both results.
   */
  private static EventChain forkAndJoin() {
    EventChain chain = chain();
    node(chain, "A", "/a", "/b");
    node(chain, "B", "/b", "/c");
    node(chain, "C", "/b", "/d");
    node(chain, "D", "/c", "/e").getInput().add(data(chain, "/d"));
    return chain;
  }

  private static SoftwareNode node(EventChain chain, String name, String input, String output) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    chain.getSoftware().add(node);
    node.getInput().add(data(chain, input));
    node.getOutput().add(data(chain, output));
    return node;
  }

  private static Data data(EventChain chain, String topic) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName("value");
    data.setTopicName(topic);
    data.setMessageType("std_msgs/msg/Float32");
    chain.getData().add(data);
    return data;
  }

  private List<Diagnostic> draw(EventChain chain, Set<Kind> kinds) throws IOException {
    Path model = Files.write(folder.resolve("model.xmi"), XmiStore.toBytes(chain));
    return Diagrams.draw(
            kinds, ModelFiles.of(List.of(model), List.of()), folder.resolve("out"), OnEdit.KEEP)
        .diagnostics();
  }

  /** Returns the PlantUML text of a chain without findings. */
  private String drawn(EventChain chain, Kind kind) throws IOException {
    assertEquals(List.of(), draw(chain, EnumSet.of(kind)));
    return Files.readString(folder.resolve("out/" + kind + ".puml"));
  }

  private String svg(Kind kind) throws IOException {
    return Files.readString(folder.resolve("out/" + kind + ".svg"));
  }
}
