package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsReader;
import dev.eventchain.dds.DdsSample;
import dev.eventchain.dds.DdsWriter;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.node.DdsAttachment;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.wire.DdsDomain;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** Tests the world with nodes that run elsewhere, here participants of this process. */
@ResourceLock("processes of nodes")
class AttachedTest {

  private static final QosSettings QOS = QosSettings.named("default").orElseThrow();
  private static final QosSettings SENSOR = QosSettings.named("sensor_data").orElseThrow();
  private static final MessageCatalog MESSAGES =
      MessageCatalog.of(List.of(AebProject.EXAMPLE.resolve("software-base/msg")));
  private static final String LIDAR = "/carla/ego_vehicle/lidar";
  private static final String STATUS = "/carla/ego_vehicle/vehicle_status";
  private static final String CONTROL = "/carla/ego_vehicle/vehicle_control_cmd";
  private static final String CONTROL_TYPE = "carla_msgs/msg/CarlaEgoVehicleControl";
  private static final String NUMBER = "std_msgs/msg/Float32";
  private static final NodeLimits AT_ONCE =
      new NodeLimits(Duration.ofSeconds(10), Duration.ofMillis(1), Duration.ofHours(1));

  private static final NodeLimits SOON =
      new NodeLimits(Duration.ofSeconds(10), Duration.ofSeconds(1), Duration.ofHours(1));

  private final DdsDomain domain = DdsDomain.find();
  private final DdsAttachment where =
      new DdsAttachment(domain.number(), DdsParticipant.loopbackConfiguration(domain.tag()));
  private PythonEnvironment python;
  private DdsParticipant others;

  @TempDir Path folder;

  @BeforeEach
  void join() {
    python = PythonEnvironment.ensureWithCycloneDds(line -> {});
    others =
        DdsParticipant.on(
            DdsLibrary.load(python.cycloneDds()), where.domain(), where.configuration());
  }

  @AfterEach
  void leave() {
    others.close();
    domain.release();
  }

  private static MessageType type(String name) {
    return MESSAGES.find(name).orElseThrow();
  }

  /** Returns a request with short scenarios, except one that its events need to be longer. */
  private SimulationRequest request(String... names) throws IOException {
    List<Scenario> scenarios = new ArrayList<>();
    for (String name : names) {
      Path file = folder.resolve(name + ".yaml");
      Files.writeString(
          file,
          """
          name: %s
          title: Vehicle ahead, far away
          requirements: [AEB-4]
          seed: 1
          duration_s: %s
          ego: {speed_kmh: 30}
          actors: [{gap_m: 40, speed_kmh: 30}]
          accept: {never_brakes: true}
          """
              .formatted(name, name.equals("vanishes") ? 60 : 0.7));
      scenarios.add(Scenario.read(file, AebProject.BENCH));
    }
    return new AebProject(Files.createTempDirectory(folder, "project"))
        .request(scenarios)
        .with(settings -> settings.withAttachment(where));
  }

  private SimulationResult run(SimulationRequest request) throws InterruptedException {
    return Simulation.run(request, python, verdict -> {});
  }

  private Diagnostic refusal(SimulationRequest request) {
    return assertThrows(DiagnosticException.class, () -> run(request)).diagnostics().get(0);
  }

  private void reads(String topic, String type, Consumer<DdsSample> listener) {
    QosSettings qos = topic.equals(LIDAR) ? SENSOR : QOS;
    others.reader(topic, type(type), qos.withHistory(QosSettings.History.KEEP_ALL), listener);
  }

  /** Returns a node that answers each scan with this demand on the brake. */
  private DdsWriter brakes(double demand) {
    others.announce("brakes");
    DdsWriter control = others.writer(CONTROL, type(CONTROL_TYPE), QOS);
    byte[] command = CdrCodec.encode(MessageValue.of(type(CONTROL_TYPE)).set("brake", demand));
    reads(STATUS, "carla_msgs/msg/CarlaEgoVehicleStatus", sample -> {});
    reads(LIDAR, "sensor_msgs/msg/PointCloud2", sample -> control.write(command));
    return control;
  }

  private static boolean isOverrun(ScenarioVerdict verdict) {
    return verdict.criteria().stream()
        .allMatch(each -> !each.tested() && each.measured().contains("behind the clock"));
  }

  private static List<String> ids(SimulationResult result) {
    return result.diagnostics().stream().map(Diagnostic::id).distinct().toList();
  }

  @Test
  void thatNobodyIsThereIsSaidWithTheTopics() throws Exception {
    Diagnostic found = refusal(request("alone").with(it -> it.withLimits(AT_ONCE)));
    assertEquals("simulation.wire.unmatched", found.id());
    assertEquals(
        "No node was found in domain "
            + domain.number()
            + ", within 0 s: nothing reads /carla/ego_vehicle/lidar (sensor_msgs/msg/PointCloud2);"
            + " nothing reads /carla/ego_vehicle/vehicle_status"
            + " (carla_msgs/msg/CarlaEgoVehicleStatus);"
            + " nothing writes /carla/ego_vehicle/vehicle_control_cmd"
            + " (carla_msgs/msg/CarlaEgoVehicleControl).",
        found.message());
  }

  @Test
  void otherTypesDefinitionsAndWorldsAreNamed() throws Exception {
    String status = "carla_msgs/msg/CarlaEgoVehicleStatus";
    MessageCatalog old = MessageCatalog.ofTexts(Map.of(status, "float32 velocity\n"));
    others.announce("brakes");
    others.writer(CONTROL, type(NUMBER), QOS);
    others.writer("/clock", type("rosgraph_msgs/msg/Clock"), QOS);
    others.reader(STATUS, old.find(status).orElseThrow(), QOS);
    reads(LIDAR, "sensor_msgs/msg/PointCloud2", sample -> {});
    Diagnostic found = refusal(request("misfit").with(it -> it.withLimits(AT_ONCE)));
    assertEquals("simulation.wire.unmatched", found.id());
    assertEquals(
        "The nodes in domain "
            + domain.number()
            + " do not meet the world, within 0 s: /carla/ego_vehicle/vehicle_control_cmd is"
            + " written by node /brakes as std_msgs/msg/Float32, and here it is"
            + " carla_msgs/msg/CarlaEgoVehicleControl; /carla/ego_vehicle/vehicle_status is read"
            + " by node /brakes with another definition of carla_msgs/msg/CarlaEgoVehicleStatus;"
            + " /clock is written by node /brakes, too. Nodes found: /brakes.",
        found.message());
  }

  @Test
  void aReliableReaderOfABestEffortSensorGetsNothing() throws Exception {
    others.announce("brakes");
    others.writer(CONTROL, type(CONTROL_TYPE), QOS);
    reads(STATUS, "carla_msgs/msg/CarlaEgoVehicleStatus", sample -> {});
    others.reader(LIDAR, type("sensor_msgs/msg/PointCloud2"), QOS);
    requireMisfit(refusal(request("misfit").with(it -> it.withLimits(SOON))), "brakes");
  }

  @Test
  void aReliableNodeOfTheChainIsNotReplacedByAnotherReader() throws Exception {
    brakes(0);
    try (DdsParticipant second = another("object_detection")) {
      second.reader(LIDAR, type("sensor_msgs/msg/PointCloud2"), QOS);
      requireMisfit(refusal(request("misfit").with(it -> it.withLimits(SOON))), "object_detection");
    }
    try (DdsParticipant second = another("recorder")) {
      second.reader(LIDAR, type("sensor_msgs/msg/PointCloud2"), QOS);
      assertEquals(1, run(request("recorded")).verdicts().size());
    }
  }

  private DdsParticipant another(String node) {
    DdsParticipant participant =
        DdsParticipant.on(
            DdsLibrary.load(python.cycloneDds()), where.domain(), where.configuration());
    participant.announce(node);
    return participant;
  }

  private static void requireMisfit(Diagnostic found, String node) {
    assertEquals("simulation.wire.unmatched", found.id());
    String misfit = " is read by node /%s with an incompatible quality of service: reliability";
    assertTrue(found.message().contains(LIDAR + misfit.formatted(node)), found::message);
  }

  @Test
  void theVehicleIsJudgedAndNothingOfTheNodesIsMeasured() throws Exception {
    brakes(1);
    SimulationRequest request = request("brakes");
    SimulationResult result = run(request);
    ScenarioVerdict verdict = result.verdicts().get(0);
    assertFalse(verdict.passed());
    assertTrue(isOverrun(verdict) || verdict.tested(), verdict::toString);
    assertEquals(List.of(), result.measurements().nodes());
    MessageFlow nothing = new MessageFlow(List.of(), List.of(), List.of());
    assertEquals(nothing, result.measurements().flow());
    assertTrue(verdict.latency().isEmpty());
    assertTrue(verdict.latencies().stream().allMatch(Optional::isEmpty));
    assertTrue(
        result.measuredModel(request.chain()).getSoftware().stream()
            .allMatch(node -> node.getMeasured() == null));
    assertEquals(List.of("simulation.attached.unseen"), ids(result));
    assertEquals(
        String.format(
            Locale.ROOT,
            "The nodes were started elsewhere (Cyclone DDS, attached to domain %d): their executions, periods, execution times, latencies and ages of inputs were not measured. Nothing was received on /aeb/time_to_collision, /scan, /vehicle/brake_force.",
            domain.number()),
        result.diagnostics().get(0).message());
    assertEquals("Cyclone DDS, attached to domain " + domain.number(), result.host().driver());
    assertEquals(
        "none by Eventchain: the nodes were started elsewhere", result.host().confinement());
  }

  @Test
  void theClockIsThatOfTheWallAndNeverGoesBack() throws Exception {
    List<Long> shown = Collections.synchronizedList(new ArrayList<>());
    List<Long> stamps = Collections.synchronizedList(new ArrayList<>());
    reads("/clock", "rosgraph_msgs/msg/Clock", sample -> shown.add(time(sample, "clock")));
    reads(LIDAR, "sensor_msgs/msg/PointCloud2", sample -> stamps.add(time(sample, "header.stamp")));
    brakes(0);
    long before = wall();
    SimulationResult result = run(request("first", "second"));
    long after = wall();
    for (List<Long> times : List.of(shown, stamps)) {
      assertTrue(times.size() > 10, times::toString);
      assertEquals(times.stream().sorted().toList(), times);
      assertTrue(times.get(0) >= before && times.get(times.size() - 1) <= after);
    }
    assertTrue(shown.containsAll(stamps), "the clock shows the time of each scan");
    assertEquals(List.of("simulation.attached.unseen", "simulation.attached.state"), ids(result));
    for (ScenarioVerdict verdict : result.verdicts()) {
      assertTrue(
          verdict.criteria().stream().noneMatch(each -> each.tested() && !each.passed()),
          verdict::toString);
    }
  }

  private static long time(DdsSample sample, String field) {
    String name = field.equals("clock") ? "rosgraph_msgs/msg/Clock" : "sensor_msgs/msg/PointCloud2";
    MessageValue message = CdrCodec.decode(type(name), sample.bytes());
    long seconds = (long) message.number(field + ".sec");
    return seconds * 1_000_000_000L + (long) message.number(field + ".nanosec");
  }

  private static long wall() {
    Instant now = Instant.now();
    return now.getEpochSecond() * 1_000_000_000L + now.getNano();
  }

  @Test
  void whatVanishesIsNamed() throws Exception {
    DdsWriter control = brakes(0);
    CompletableFuture<Diagnostic> running =
        CompletableFuture.supplyAsync(
            () -> refusal(requestUnchecked("vanishes")), command -> new Thread(command).start());
    Diagnostic found;
    try (DdsReader scans = others.reader(LIDAR, type("sensor_msgs/msg/PointCloud2"), SENSOR)) {
      boolean driven = false;
      while (!driven && !running.isDone()) {
        driven = !scans.take(Duration.ofMillis(100)).isEmpty();
      }
      control.close();
      found = running.join();
    }
    assertEquals("simulation.node.lost", found.id());
    assertTrue(
        found
            .message()
            .endsWith(
                " s into the scenario, this vanished from the wire: the writer of "
                    + CONTROL
                    + " (node /brakes)."),
        found::message);
  }

  private SimulationRequest requestUnchecked(String name) {
    try {
      return request(name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void whereNothingComesNothingIsJudged() throws Exception {
    others.writer(CONTROL, type(CONTROL_TYPE), QOS);
    DdsWriter time = others.writer("/aeb/time_to_collision", type(NUMBER), QOS);
    reads(STATUS, "carla_msgs/msg/CarlaEgoVehicleStatus", sample -> {});
    byte[] number = CdrCodec.encode(MessageValue.of(type(NUMBER)));
    reads(LIDAR, "sensor_msgs/msg/PointCloud2", sample -> time.write(number));
    SimulationResult result = run(request("silent"));
    ScenarioVerdict verdict = result.verdicts().get(0);
    assertFalse(verdict.worked() || verdict.tested() || verdict.passed());
    assertEquals(List.of("simulation.node.silent", "simulation.attached.unseen"), ids(result));
    assertEquals(
        "Scenario silent: the vehicle received nothing on " + CONTROL + ".",
        result.diagnostics().get(0).message());
  }

  @Test
  void environmentNamesDomainAndConfiguration() {
    assertEquals(new DdsAttachment(0, ""), DdsAttachment.of(Map.of()));
    Map<String, String> both = Map.of("ROS_DOMAIN_ID", "42", "CYCLONEDDS_URI", "file:///a.xml");
    assertEquals(new DdsAttachment(42, "file:///a.xml"), DdsAttachment.of(both));
    String loopback = DdsParticipant.loopbackConfiguration();
    assertEquals(
        new DdsAttachment(0, loopback), DdsAttachment.of(Map.of("ROS_LOCALHOST_ONLY", "1")));
    Map<String, String> local = new TreeMap<>(both);
    local.put("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
    assertEquals(new DdsAttachment(42, loopback + ",file:///a.xml"), DdsAttachment.of(local));
    assertEquals(
        new DdsAttachment(0, "", "humble"), DdsAttachment.of(Map.of("ROS_DISTRO", "humble")));
    assertEquals(new DdsAttachment(232, ""), DdsAttachment.of(Map.of("ROS_DOMAIN_ID", "232")));
    for (String number : List.of("233", "-1", "one", "9999")) {
      Diagnostic found =
          assertThrows(
                  DiagnosticException.class,
                  () -> DdsAttachment.of(Map.of("ROS_DOMAIN_ID", number)))
              .diagnostics()
              .get(0);
      assertEquals("dds.domain.unusable", found.id());
      assertEquals("ROS_DOMAIN_ID is '" + number + "', which is not a domain.", found.message());
    }
  }

  @Test
  void configurationThatCycloneDdsRefusesIsAFinding() throws Exception {
    int free = domain.number() + 100;
    Diagnostic found =
        refusal(
            request("refused")
                .with(
                    it ->
                        it.withAttachment(
                            new DdsAttachment(free, "<CycloneDDS><No/></CycloneDDS>"))));
    assertEquals("dds.domain.unusable", found.id());
    assertTrue(found.message().startsWith("Cyclone DDS refuses domain " + free), found::message);
  }
}
