package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.PythonNames;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.project.Requirements;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Tests that the standard OCL rules, the reader of descriptions, the indexes and the nodes' runtime
 * agree on valid and equivalent names, for random names.
 */
class NamesAgreeTest {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String NODE = "Owner";
  private static final int NAMES = 1500;

  private static final List<String> PARTS =
      List.of(
          "/",
          "/",
          "/",
          "~",
          "_",
          "_",
          "__",
          ".",
          ".",
          "a",
          "b",
          "Ab",
          "B2",
          "2",
          "msg",
          "/msg/",
          "std_msgs",
          "Bool",
          "class",
          "None",
          "self",
          "main",
          "rclpy",
          "__x",
          "[2]",
          "é",
          " ",
          "-",
          "\n");

  private static final List<String> LEGAL =
      List.of("/a/Ab_2/x", "a/x", "~/x", "std_msgs/msg/Bool", "a_msgs/B2", "h.s_2.t", "_value");

  /** Kinds of names, with the rules of each party. */
  private enum Kind {
    TOPIC("TopicNameIsLegal", "modeler.topic.illegal"),
    MESSAGE_TYPE("MessageTypeIsQualified", "modeler.type.illegal"),
    FIELD("FieldNameIsPath", "modeler.field.illegal"),
    VALUE("DataNameIsIdentifier", "modeler.name.illegal");

    private final String constraint;
    private final String finding;

    Kind(String constraint, String finding) {
      this.constraint = constraint;
      this.finding = finding;
    }

    boolean isLegal(String name) {
      return switch (this) {
        case TOPIC -> RosNames.isTopic(name);
        case MESSAGE_TYPE -> RosNames.isMessageType(name);
        case FIELD -> RosNames.isFieldPath(name);
        case VALUE -> PythonNames.isFreeIdentifier(name);
      };
    }
  }

  /** Returns random names, and some that are nearly valid; none is blank. */
  private static List<String> names(long seed) {
    Random random = new Random(seed);
    Set<String> names = new TreeSet<>();
    while (names.size() < NAMES) {
      StringBuilder name = new StringBuilder();
      if (random.nextBoolean()) {
        name.append(LEGAL.get(random.nextInt(LEGAL.size())));
        name.insert(random.nextInt(name.length() + 1), PARTS.get(random.nextInt(PARTS.size())));
        name.deleteCharAt(random.nextInt(name.length()));
      }
      for (int i = random.nextInt(5); i > 0; i--) {
        name.append(PARTS.get(random.nextInt(PARTS.size())));
      }
      if (!name.toString().isBlank()) {
        names.add(name.toString());
      }
    }
    return List.copyOf(names);
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void rulesAndReaderCallTheSameNamesLegal(Kind kind) {
    List<String> names = names(kind.name().hashCode());
    Set<Integer> illegal = new TreeSet<>();
    for (int i = 0; i < names.size(); i++) {
      if (!kind.isLegal(names.get(i))) {
        illegal.add(i);
      }
    }
    assertTrue(illegal.size() > 100 && illegal.size() < NAMES - 20, illegal.size() + " illegal");
    assertEquals(show(names, illegal), show(names, violated(kind, names)), "OCL");
    assertEquals(show(names, illegal), show(names, refused(kind, names)), "modeler");
  }

  private static List<String> show(List<String> names, Set<Integer> indexes) {
    return indexes.stream().map(names::get).toList();
  }

  private static Set<Integer> violated(Kind kind, List<String> names) {
    EventChain chain = FACTORY.createEventChain();
    for (String name : names) {
      Data data = FACTORY.createData();
      data.setName(kind == Kind.VALUE ? name : "x");
      data.setTopicName(kind == Kind.TOPIC ? name : "/x");
      data.setMessageType(kind == Kind.MESSAGE_TYPE ? name : "std_msgs/Bool");
      data.setFieldName(kind == Kind.FIELD ? name : "data");
      chain.getData().add(data);
    }
    return check(chain).stream()
        .filter(found -> found.rule().equals("Data::" + kind.constraint))
        .map(found -> Integer.valueOf(found.location().element()))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns the findings of the standard rules and others, with positions as elements. */
  private static List<Diagnostic> check(EventChain chain, String... others) {
    List<SourceText> documents = new ArrayList<>();
    documents.add(EventChainMetamodel.constraints());
    for (String other : others) {
      documents.add(SourceText.of("rule.ocl", other));
    }
    OclRules rules = OclRules.parse(documents, List.of(EventchainPackage.eINSTANCE));
    assertEquals(List.of(), rules.diagnostics());
    return OclValidator.validate(
            rules,
            List.of(chain),
            element ->
                SourceLocation.NONE.withElement(
                    element == chain
                        ? "chain"
                        : String.valueOf(element.eContainer().eContents().indexOf(element))))
        .diagnostics();
  }

  private static Set<Integer> refused(Kind kind, List<String> names) {
    ArrayNode description = JsonNodeFactory.instance.arrayNode();
    ObjectNode component = description.addObject();
    component.put("name", "Reader").put("description", "Reads.").put("frequency", 1.0);
    component.putArray("requirements");
    ArrayNode input = component.putArray("input");
    for (int i = 0; i < names.size(); i++) {
      String name = names.get(i);
      ObjectNode port = input.addObject();
      port.put("topic", kind == Kind.TOPIC ? name : "/x");
      port.put("message_type", kind == Kind.MESSAGE_TYPE ? name : "std_msgs/Bool");
      ObjectNode value = port.putArray("values").addObject();
      value.put("name", kind == Kind.VALUE ? name : "x" + i);
      value.put("field", kind == Kind.FIELD ? name : "data");
      value.put("type", "bool").put("unit", "").put("description", "");
    }
    component.putArray("output");
    return EventChainReader.read(
            SourceText.of("chain.json", description.toString()),
            "chain",
            Requirements.read(SourceText.of("requirements.md", "- R-1: It shall work.\n")).items(),
            OptionalDouble.empty())
        .diagnostics()
        .stream()
        .filter(found -> found.id().equals(kind.finding))
        .map(found -> Integer.valueOf(found.location().element().split("/", -1)[3]))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void theRuntimeTakesAndResolvesTheSameTopics() throws Exception {
    List<String> names = names(5);
    List<String> expected = new ArrayList<>();
    for (String name : names) {
      expected.add(RosNames.isTopic(name) ? RosNames.resolve(name, NODE) : null);
    }
    JsonNode found = runtime(names);
    List<String> resolved = new ArrayList<>();
    found.forEach(name -> resolved.add(name.isNull() ? null : name.textValue()));
    assertEquals(expected, resolved);
  }

  private static JsonNode runtime(List<String> names) throws IOException, InterruptedException {
    Path script = Path.of("src/test/python/resolve_topics.py").toAbsolutePath();
    Path python = PythonEnvironment.ensure(line -> {}).executable();
    ProcessBuilder builder = new ProcessBuilder(python.toString(), script.toString(), NODE);
    builder
        .environment()
        .put("PYTHONPATH", Path.of("../../robot/runtime/python").toAbsolutePath().toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    Process process = builder.redirectError(ProcessBuilder.Redirect.INHERIT).start();
    try (var stdin = process.getOutputStream()) {
      JSON.writeValue(stdin, names);
    }
    byte[] output = process.getInputStream().readAllBytes();
    assertEquals(0, process.waitFor());
    return JSON.readTree(output);
  }

  @Test
  void theRulesKnowTheProfilesOfQualityOfService() {
    List<String> names = new ArrayList<>(QosSettings.names());
    assertTrue(names.size() >= 8, names::toString);
    names.forEach(name -> assertEquals(List.of(), profile(name), name));
    for (String name : List.of("sensor", "sensor_data ", "default|sensor_data", "defaults")) {
      assertEquals(List.of("QosProfile::ProfileIsKnown"), profile(name), name);
    }
  }

  private static List<String> profile(String name) {
    EventChain chain = FACTORY.createEventChain();
    chain.setName("chain");
    Data data = FACTORY.createData();
    data.setName("x");
    data.setTopicName("/x");
    data.setMessageType("std_msgs/Bool");
    data.setFieldName("data");
    data.setQos(FACTORY.createQosProfile());
    data.getQos().setName(name);
    chain.getData().add(data);
    return check(chain).stream().map(Diagnostic::rule).toList();
  }

  /** The templates' rule is the same text as that of OCL, which is evaluated. */
  @Test
  void nodesAreCalledTheSame() throws IOException {
    Random random = new Random(11);
    EventChain chain = FACTORY.createEventChain();
    List<String> names = new ArrayList<>(List.of("TTC_Calculation", "ObjectDetection", "ABCd2Ef"));
    for (int i = 0; i < NAMES; i++) {
      StringBuilder name = new StringBuilder("x");
      random.ints(random.nextInt(9), 0, 8).forEach(at -> name.append("aBcD_2_E".charAt(at)));
      names.add(name.toString());
    }
    for (String name : names) {
      SoftwareNode node = FACTORY.createSoftwareNode();
      node.setName(name);
      node.setDescription("/" + RosNames.nodeName(name) + "/x");
      Data data = FACTORY.createData();
      data.setTopicName("~/x");
      chain.getData().add(data);
      node.getOutput().add(data);
      chain.getSoftware().add(node);
    }
    String rule =
        """
        context SoftwareNode
          inv Tell: self.output->forAll(d | d.topicOf(self) = self.description)
        """;
    assertEquals(
        List.of(),
        check(chain, rule).stream().filter(f -> f.rule().equals("SoftwareNode::Tell")).toList());
    assertEquals("ttc_calculation", RosNames.nodeName("TTC_Calculation"));
    assertEquals("object_detection", RosNames.nodeName("ObjectDetection"));
    for (String file : List.of("metamodel/eventchain.ocl", "templates/python/names.mtl")) {
      String text = Files.readString(Path.of("../../..", file)).replaceAll("\\s+", "");
      assertTrue(
          text.contains(
              ".replaceAll('([a-z0-9])([A-Z])','$1_$2').replaceAll('([A-Z])([A-Z][a-z])','$1_$2')"
                  + ".toLowerCase().replaceAll('_+','_')"),
          file);
    }
  }

  /** Components write and read topics and fields, many of them equivalent or nearly so. */
  @Test
  void rulesAndIndexSeeTheSameFlow() {
    Random random = new Random(7);
    int flows = 0;
    for (int round = 0; round < 40; round++) {
      EventChain chain = chain(random);
      DataFlowIndex index = DataFlowIndex.of(chain);
      TreeMap<String, List<String>> expected = new TreeMap<>();
      for (SoftwareNode node : chain.getSoftware()) {
        expected.put(
            node.getName(), index.successors(node).stream().map(n -> n.getName()).toList());
        flows += index.successors(node).size();
      }
      TreeMap<String, List<String>> found = new TreeMap<>();
      String rule =
          """
          context SoftwareNode
            -- @message {self.name}:{self.successors->iterate(n; all : String = ' ' |
            --   all.concat(n.name).concat(' '))}
            inv Tell: self.name = null
          """;
      for (Diagnostic finding : check(chain, rule)) {
        if (finding.rule().equals("SoftwareNode::Tell")) {
          String[] told = finding.message().split(":", -1);
          found.put(told[0], List.of(told[1].strip().split(" ")));
        }
      }
      found.replaceAll((name, all) -> all.equals(List.of("")) ? List.of() : all);
      assertEquals(expected, found);
    }
    assertTrue(flows > 100, flows + " flows");
  }

  private static EventChain chain(Random random) {
    EventChain chain = FACTORY.createEventChain();
    for (int i = 0; i < 6; i++) {
      SoftwareNode node = FACTORY.createSoftwareNode();
      node.setName("N" + i);
      chain.getSoftware().add(node);
      for (int j = random.nextInt(3); j >= 0; j--) {
        node.getInput().add(data(chain, random));
        node.getOutput().add(data(chain, random));
      }
    }
    return chain;
  }

  private static Data data(EventChain chain, Random random) {
    List<String> topics = List.of("/a/x", "a/x", "/x", "x", "~/x", "/n1/x", "n2/x", "/a/x/y");
    List<String> fields = List.of("h", "h.s", "h.s.t", "h.st", "hs", "r", "r[2]", "r[2].x", "r2");
    if (random.nextInt(8) == 0) {
      return chain.getData().isEmpty() ? data(chain, random) : chain.getData().get(0);
    }
    Data data = FACTORY.createData();
    if (random.nextInt(10) > 0) {
      data.setTopicName(topics.get(random.nextInt(topics.size())));
    }
    if (random.nextInt(10) > 0) {
      data.setFieldName(fields.get(random.nextInt(fields.size())));
    }
    chain.getData().add(data);
    return data;
  }
}
