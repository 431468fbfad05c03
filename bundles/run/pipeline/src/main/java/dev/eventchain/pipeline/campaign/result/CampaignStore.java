package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.stage.RunContext;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * The folder of a campaign's results. Cases are kept in numbered files while it runs, so that one
 * that is killed goes on, and in one file at its end.
 */
public final class CampaignStore implements AutoCloseable {

  public static final String FOLDER = "campaigns";
  static final String CASES = "cases.json";
  public static final String TABLE = "cases.csv";
  public static final String PAGE = "report.html";

  public static final String POINTS = "points.json";

  private static final List<String> RESULTS = List.of(CASES, TABLE, PAGE, POINTS);
  private static final String PARTS = "parts";
  private static final long PAUSE = 500;

  /**
   * Cases of one state of all that they depend on.
   *
   * @param campaign the campaign's name
   * @param inputs a hash of all files that the results depend on
   * @param platform what simulates, with which results may change: Python, Java, processor,
   *     confinement
   * @param complete false while the campaign runs
   */
  public record Cases(
      String campaign,
      String inputs,
      String platform,
      Shard shard,
      boolean complete,
      List<CampaignRow> rows) {

    public Cases {
      rows = List.copyOf(rows);
    }

    /** Returns whether these cases and others can be of one table. */
    boolean isLike(Cases other) {
      return inputs.equals(other.inputs) && platform.equals(other.platform);
    }

    Cases with(Collection<CampaignRow> some, boolean isComplete) {
      return new Cases(campaign, inputs, platform, shard, isComplete, List.copyOf(some));
    }
  }

  private final Path folder;
  private final OutputFolder output;
  private final Cases empty;
  private final BooleanSupplier unchanged;
  private final Map<CampaignCase, CampaignRow> rows = new TreeMap<>(CampaignCase.ORDER);
  private final List<CampaignRow> unsaved = new ArrayList<>();
  private int parts;
  private final ScheduledExecutorService saving =
      Executors.newSingleThreadScheduledExecutor(CampaignStore::thread);
  private Optional<Future<?>> saved = Optional.empty();

  /**
   * Opens the folder, with the results of an interrupted campaign with the same inputs.
   *
   * @param results the folder with those of all campaigns
   * @param unchanged returns whether the results so far are of these inputs
   */
  public CampaignStore(Path results, Cases empty, BooleanSupplier unchanged) {
    this.folder = results.resolve(empty.shard().folder(empty.campaign()));
    this.output = OutputFolder.open(folder);
    this.empty = empty;
    this.unchanged = unchanged;
    output.write(RunContext.IGNORE, new byte[0], OutputFolder.OnEdit.OVERWRITE);
    recall(CASES);
    while (recall(part(parts + 1)) || output.read(part(parts + 1)).isPresent()) {
      parts++;
    }
  }

  /**
   * Removes what is of other inputs, and lets results be kept from now on.
   *
   * @param others files that are of the same inputs as the table
   */
  public void begin(String... others) {
    boolean same = kept(CASES).isPresent();
    if (!same) {
      RESULTS.forEach(output::remove);
      List.of(others).forEach(output::removeAll);
    }
    saved =
        Optional.of(saving.scheduleAtFixedRate(this::save, PAUSE, PAUSE, TimeUnit.MILLISECONDS));
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "campaign results");
    thread.setDaemon(true);
    return thread;
  }

  private static String part(int number) {
    return PARTS + String.format(Locale.ROOT, "/%06d.json", number);
  }

  private boolean recall(String name) {
    Optional<Cases> same = kept(name);
    same.ifPresent(it -> it.rows().forEach(row -> rows.put(row.id(), row)));
    return same.isPresent();
  }

  /**
   * Returns the cases of these inputs in a file, unless somebody else has written or changed it.
   */
  private Optional<Cases> kept(String name) {
    return output.hasRecords() && output.isEdited(name)
        ? Optional.empty()
        : output.read(name).flatMap(CampaignStore::read).filter(empty::isLike);
  }

  /** Returns the cases in a file; empty if it is another or a broken file. */
  static Optional<Cases> read(byte[] bytes) {
    return ResultJson.ifValid(bytes, Cases.class);
  }

  public Path path(String name) {
    return folder.resolve(name);
  }

  /** Returns the result of a case, if it is known. */
  public synchronized Optional<CampaignRow> find(CampaignCase id) {
    return Optional.ofNullable(rows.get(id));
  }

  /** Returns all results, in the order of their values. */
  public synchronized List<CampaignRow> rows() {
    return List.copyOf(rows.values());
  }

  /**
   * Keeps a result, which is in a file half a second later.
   *
   * @throws DiagnosticException if results can no longer be written
   */
  public synchronized void add(CampaignRow row) {
    rows.put(row.id(), row);
    unsaved.add(row);
    if (saved.filter(Future::isDone).isPresent()) { // It failed; this says why.
      save();
    }
  }

  /**
   * Writes the results that are in no file, unless they may be of other inputs: after a kill,
   * nobody else would see an edit that was taken back.
   */
  public synchronized void save() {
    if (!unsaved.isEmpty() && unchanged.getAsBoolean()) {
      // Counted once it is there: behind a gap, nobody would look for it.
      write(part(parts + 1), ResultJson.bytes(empty.with(unsaved, false)));
      parts++;
      unsaved.clear();
    }
  }

  /** Forgets all other cases. */
  public synchronized void retain(Collection<CampaignCase> cases) {
    Set<CampaignCase> kept = new TreeSet<>(CampaignCase.ORDER);
    kept.addAll(cases);
    rows.keySet().retainAll(kept);
    unsaved.clear();
  }

  /** Writes all cases into one file, after which nothing is missing. */
  public synchronized void complete() {
    write(CASES, ResultJson.bytes(empty.with(rows.values(), true)));
    output.removeAll(PARTS);
  }

  /** Drops all results. */
  public synchronized void discard() {
    unsaved.clear();
    rows.clear();
    RESULTS.forEach(output::remove);
    output.removeAll(PARTS);
  }

  public void write(String name, byte[] content) {
    output.write(name, content, OutputFolder.OnEdit.OVERWRITE);
  }

  @Override
  public void close() {
    saving.shutdownNow();
    synchronized (this) {
      output.close();
    }
  }
}
