package dev.eventchain.description;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.ModelComparison;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.Processors;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.History;
import dev.eventchain.model.eventchain.Liveliness;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Reliability;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Writing and reading any model gives an equal model and equal bytes. */
class RoundTripTest {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  @Property(tries = 200, seed = "1")
  void descriptionsKeepTheModel(@ForAll("chains") EventChain chain) {
    String written = EventChainWriter.write(chain);
    EventChain again = read(written);
    assertEquals(
        List.of(), ModelComparison.compare(chain, again, element -> SourceLocation.NONE), written);
    assertEquals(written, EventChainWriter.write(again));
  }

  @Property(tries = 100, seed = "1")
  void xmiKeepsTheModelAndItsBytes(@ForAll("chains") EventChain chain) throws IOException {
    byte[] written = XmiStore.toBytes(chain);
    assertArrayEquals(written, XmiStore.toBytes(chain));
    Path folder = Files.createTempDirectory("xmi");
    Path file = Files.write(folder.resolve("chain.xmi"), written);
    EventChain again = (EventChain) EventChainMetamodel.store(folder).load(file).roots().get(0);
    Files.delete(file);
    Files.delete(folder);
    assertArrayEquals(written, XmiStore.toBytes(again));
    assertEquals(List.of(), ModelComparison.compare(chain, again, element -> SourceLocation.NONE));
  }

  @Provide
  Arbitrary<EventChain> chains() {
    return Arbitraries.longs().map(seed -> chain(new Random(seed)));
  }

  private static EventChain read(String description) {
    Modeled<EventChain> read =
        EventChainReader.read(
            SourceText.of("chain.json", description), "chain", List.of(), OptionalDouble.empty());
    assertEquals(List.of(), read.diagnostics());
    return read.root();
  }

  private static EventChain chain(Random random) {
    EventChain chain = FACTORY.createEventChain();
    chain.setName("chain");
    int count = 1 + random.nextInt(5);
    for (int i = 0; i < count; i++) {
      SoftwareNode node = FACTORY.createSoftwareNode();
      node.setName("Node_" + i);
      if (random.nextBoolean()) {
        node.setDescription(text(random));
      }
      if (random.nextBoolean()) {
        node.setFrequency(random.nextDouble() * Math.pow(10, random.nextInt(7) - 3) + 1e-9);
      }
      if (random.nextBoolean()) {
        node.setWorstCaseExecutionTime(random.nextInt(100) / 8.0);
      }
      chain.getSoftware().add(node);
      addData(chain, node.getInput(), random);
      addData(chain, node.getOutput(), random);
      if (random.nextBoolean()) {
        node.getSynchronized().addAll(node.getInput());
        node.setTolerance(random.nextInt(100) + 0.5);
        Processors.map(node, "ecu" + random.nextInt(2), chain);
        node.setPriority(random.nextInt(100) - 50);
      }
    }
    linkAsTheReaderDoes(chain);
    return chain;
  }

  private static void addData(EventChain chain, List<Data> side, Random random) {
    int count = random.nextInt(4);
    for (int i = 0; i < count; i++) {
      Data data = FACTORY.createData();
      data.setName("value_" + i);
      data.setTopicName("/topic_" + random.nextInt(4));
      data.setMessageType("std_msgs/msg/Float" + (random.nextBoolean() ? 32 : 64));
      data.setFieldName(random.nextBoolean() ? "data" : "header.stamp.sec");
      if (random.nextBoolean()) {
        data.setUnit(text(random));
      }
      if (random.nextBoolean()) {
        data.setComponentUnit(text(random));
      }
      if (random.nextBoolean()) {
        data.setQos(profile(random));
        data.setWorstCaseTransportTime(random.nextInt(4) / 4.0);
      }
      chain.getData().add(data);
      side.add(data);
    }
  }

  private static QosProfile profile(Random random) {
    QosProfile qos = FACTORY.createQosProfile();
    qos.setName(random.nextBoolean() ? "default" : "sensor_data");
    if (random.nextBoolean()) {
      qos.setReliability(random.nextBoolean() ? Reliability.RELIABLE : Reliability.BEST_EFFORT);
    }
    if (random.nextBoolean()) {
      qos.setHistory(History.KEEP_ALL);
    }
    if (random.nextBoolean()) {
      qos.setDepth(random.nextInt(1000));
    }
    if (random.nextBoolean()) {
      qos.setDeadline(random.nextDouble() * 1000);
    }
    if (random.nextBoolean()) {
      qos.setLiveliness(Liveliness.MANUAL_BY_TOPIC);
      qos.setLeaseDuration(random.nextDouble() * 1000);
    }
    return qos;
  }

  private static void linkAsTheReaderDoes(EventChain chain) {
    List<SoftwareNode> nodes = chain.getSoftware();
    for (int i = 0; i < nodes.size(); i++) {
      for (int j = nodes.size() - 1; j > i; j--) {
        if (sharesTopic(nodes.get(i).getOutput(), nodes.get(j).getInput())) {
          nodes.get(i).setNextstep(nodes.get(j));
        }
      }
    }
  }

  private static boolean sharesTopic(List<Data> outputs, List<Data> inputs) {
    return outputs.stream()
        .anyMatch(o -> inputs.stream().anyMatch(i -> i.getTopicName().equals(o.getTopicName())));
  }

  /** Returns text that is difficult for formats: quotes, markup, line ends, tabs, emoji. */
  private static String text(Random random) {
    String alphabet = "aZ0 \t\n\r\"'<>&;]}[{/\\\u00e4\u2028\uFFFD%$#`";
    StringBuilder text = new StringBuilder("x");
    int length = random.nextInt(12);
    for (int i = 0; i < length; i++) {
      text.append(alphabet.charAt(random.nextInt(alphabet.length())));
    }
    return text.append(random.nextBoolean() ? "\uD83D\uDE97" : "").toString();
  }
}
