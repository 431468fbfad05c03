package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.campaign.result.CampaignMerge;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.SourceName;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/**
 * A campaign whose cases are simulated by the nodes of a Ray cluster: parts as {@code --shard}
 * makes them, whose cases are kept as they come, so that an interrupted campaign goes on.
 */
final class RayCampaign {

  /** Cases of a part for each of its processors, which take some seconds. */
  private static final int CASES = 50;

  /** Parts for each that runs at once, so that all end at about the same time. */
  private static final int ROUNDS = 3;

  private static final int MOST_PARTS = 999_999;

  /** Dependencies of a result besides files: see the fingerprint of the stage. */
  private static final Set<String> SETTINGS = Set.of("EVENTCHAIN_CONFINEMENT");

  /** Folders of the output folder that no stage reads. */
  private static final String[] NO_INPUTS = {
    CampaignStore.FOLDER, Searches.FOLDER, "mcap", "curves"
  };

  private final RunContext run;
  private final CampaignPlan plan;
  private final CampaignEngine engine;
  private final CampaignStore store;
  private final CampaignStore.Cases own;

  /**
   * Creates it.
   *
   * @param own what the cases of the parts have to be of
   */
  RayCampaign(
      RunContext run,
      CampaignPlan plan,
      CampaignEngine engine,
      CampaignStore store,
      CampaignStore.Cases own) {
    this.run = run;
    this.plan = plan;
    this.engine = engine;
    this.store = store;
    this.own = own;
  }

  /**
   * Simulates the cases that are not known.
   *
   * @param sources all that the results depend on
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code campaign.engine} if there is no
   *     such cluster or a part failed, {@code campaign.merge} if one is of another state or other
   *     versions; the cases that came before are kept
   */
  void simulate(Combinations combinations, Fingerprint sources) {
    requireSendable();
    long open = combinations.of(Shard.ALL).stream().filter(this::isOpen).count();
    if (open == 0) {
      return;
    }
    PythonEnvironment python =
        PythonEnvironment.ensureWithRay(said -> run.progress().step(Stage.SIMULATE, said));
    CampaignProgress progress =
        new CampaignProgress(run.progress(), store.rows().size(), (int) open);
    try (RayDriver driver = new RayDriver(python.executable(), SourceLocation.of(plan.file()))) {
      run.progress().step(Stage.SIMULATE, "sending project and program to the cluster");
      driver.send(request(sources));
      int count = parts(combinations, driver.receive());
      driver.send(Map.of("count", count, "parts", combinations.parts(count, this::isOpen)));
      for (JsonNode next = driver.receive(); !next.has("ended"); next = driver.receive()) {
        add(next, new Shard(next.path("part").asInt(), count), progress);
      }
    } finally {
      store.save();
    }
  }

  /** Refuses files that a campaign names by absolute paths, where nodes do not have them. */
  private void requireSendable() {
    List<Diagnostic> problems =
        plan.named().stream()
            .filter(name -> Path.of(name).isAbsolute())
            .map(
                name ->
                    Diagnostic.of(
                            CampaignRules.ENGINE,
                            "The nodes of a cluster have no file '" + name + "'.",
                            SourceLocation.of(plan.file()))
                        .withHint("Name it by its path from the campaign file."))
            .toList();
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
  }

  private boolean isOpen(CampaignCase id) {
    return store.find(id).isEmpty();
  }

  /** Returns how many parts there are: at least two, since the whole is no part. */
  private static int parts(Combinations combinations, JsonNode cluster) {
    int slots = cluster.path("slots").asInt(1);
    int cases = CASES * cluster.path("processors").asInt(1);
    int wanted = Math.max(combinations.of(Shard.ALL).size() / cases, ROUNDS * slots);
    return Math.max(2, Math.min(Math.min(wanted, combinations.count()), MOST_PARTS));
  }

  /** Keeps the cases of a part. */
  private void add(JsonNode part, Shard shard, CampaignProgress progress) {
    byte[] bytes = part.path("cases").asText().getBytes(StandardCharsets.UTF_8);
    CampaignStore.Cases cases =
        CampaignMerge.require(bytes, own, shard, part.path("node").asText());
    for (CampaignRow row : cases.rows()) {
      if (isOpen(row.id())) {
        store.add(row);
        progress.done(row.result());
      }
    }
  }

  private Map<String, Object> request(Fingerprint sources) {
    Path project = absolute(run.project().folder());
    Path output = absolute(run.options().output());
    Map<String, Object> request = new TreeMap<>();
    request.put("address", engine.address());
    String classPath = System.getProperty("java.class.path");
    request.put(
        "class_path",
        Stream.of(classPath.split(File.pathSeparator, -1))
            .map(entry -> absolute(Path.of(entry)).toString())
            .toList());
    request.put("java_options", javaOptions());
    request.put("arguments", arguments(project));
    request.put("settings", settings());
    request.put("output", output.toString());
    request.put("files", files(sources, project, output));
    request.put(
        "folders",
        List.of(
            folder(project, List.of(output, project.resolve("evaluation")), false),
            folder(output, Stream.of(NO_INPUTS).map(output::resolve).toList(), true)));
    return request;
  }

  private static List<String> javaOptions() {
    return List.of(
        "-XX:+UseSerialGC",
        "-XX:TieredStopAtLevel=1",
        "-Xshare:auto",
        "-Xlog:disable",
        "-Xmx" + Runtime.getRuntime().maxMemory() / (1 << 20) + "m");
  }

  private List<String> arguments(Path project) {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "campaign",
                CampaignEngine.FILES + project,
                CampaignEngine.FILES + absolute(plan.file())));
    plan.part().ifPresent(part -> arguments.addAll(List.of("--only", part)));
    arguments.addAll(engine.options());
    return arguments;
  }

  private static Map<String, String> settings() {
    Map<String, String> settings = new TreeMap<>(System.getenv());
    settings.keySet().retainAll(SETTINGS);
    return settings;
  }

  /** Returns whether a path is that of a tool's own file, or in such a folder: .git, .venv. */
  private static boolean isHidden(Path path) {
    return StreamSupport.stream(path.spliterator(), false)
        .anyMatch(name -> name.toString().startsWith("."));
  }

  /**
   * Returns the files that are in none of the two folders, or hidden in the project: constraints
   * that others import, tables.
   */
  private List<String> files(Fingerprint sources, Path project, Path output) {
    Stream<Path> read =
        sources.sources().keySet().stream().map(source -> SourceName.file(source, run));
    Stream<Path> tables = plan.tables().stream();
    return Stream.of(read, tables, Stream.of(plan.file()), engine.files().stream())
        .flatMap(Function.identity())
        .map(RayCampaign::absolute)
        .filter(file -> !file.startsWith(output))
        .filter(file -> !file.startsWith(project) || isHidden(project.relativize(file)))
        .filter(Files::isRegularFile)
        .map(Path::toString)
        .distinct()
        .sorted()
        .toList();
  }

  private static Map<String, Object> folder(Path folder, List<Path> without, boolean hidden) {
    return Map.of(
        "folder",
        folder.toString(),
        "without",
        without.stream().map(Path::toString).toList(),
        "hidden",
        hidden);
  }

  private static Path absolute(Path path) {
    return path.toAbsolutePath().normalize();
  }
}
