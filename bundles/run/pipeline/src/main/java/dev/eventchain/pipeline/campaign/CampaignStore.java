package dev.eventchain.pipeline.campaign;

import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.stage.RunContext;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The folder of a campaign's results. Cases are kept in numbered files while it runs, so that one
 * that is killed goes on, and in one file at its end.
 */
final class CampaignStore implements AutoCloseable {

  static final String FOLDER = "campaigns";
  static final String CASES = "cases.json";
  static final String TABLE = "cases.csv";
  static final String PAGE = "report.html";

  private static final String PARTS = "parts";
  private static final long PAUSE = 500_000_000L;

  /**
   * Cases of one state of all that they depend on.
   *
   * @param campaign the campaign's name
   * @param inputs a hash of all that the results depend on
   * @param combinations the combinations of the whole campaign, before a boundary is searched
   * @param complete false while the campaign runs
   */
  record Cases(
      String campaign,
      String inputs,
      Shard shard,
      int combinations,
      boolean complete,
      List<CampaignRow> rows) {

    Cases {
      rows = List.copyOf(rows);
    }
  }

  private final Path folder;
  private final OutputFolder output;
  private final Cases empty;
  private final Map<CampaignCase, CampaignRow> rows = new TreeMap<>(CampaignCase.ORDER);
  private final List<CampaignRow> unsaved = new ArrayList<>();
  private int parts;
  private long saved = System.nanoTime();

  /** Opens the folder, with the results of an interrupted campaign with the same inputs. */
  CampaignStore(Path results, Cases empty) {
    this.folder = results.resolve(FOLDER).resolve(empty.shard().folder(empty.campaign()));
    this.output = OutputFolder.open(folder);
    this.empty = empty;
    output.write(RunContext.IGNORE, new byte[0], OutputFolder.OnEdit.OVERWRITE);
    boolean same = recall(CASES);
    while (recall(part(parts + 1)) || output.read(part(parts + 1)).isPresent()) {
      parts++;
    }
    if (!same && rows.isEmpty()) {
      List.of(CASES, TABLE, PAGE).forEach(output::remove);
      output.removeAll(PARTS);
      parts = 0;
    }
  }

  private static String part(int number) {
    return PARTS + "/%06d.json".formatted(number);
  }

  private boolean recall(String name) {
    Optional<Cases> known = output.read(name).flatMap(CampaignStore::read);
    Optional<Cases> same = known.filter(it -> it.inputs().equals(empty.inputs()));
    same.ifPresent(it -> it.rows().forEach(row -> rows.put(row.id(), row)));
    return same.isPresent();
  }

  /** Returns the cases in a file; empty if it is another or a broken file. */
  static Optional<Cases> read(byte[] bytes) {
    try {
      return Optional.of(ResultJson.read(bytes, Cases.class));
    } catch (IOException | RuntimeException e) {
      return Optional.empty(); // it only costs the time to simulate them again
    }
  }

  Path path(String name) {
    return folder.resolve(name);
  }

  /** Returns the result of a case, if it is known. */
  Optional<CampaignRow> find(CampaignCase id) {
    return Optional.ofNullable(rows.get(id));
  }

  /** Returns all results, in the order of their values. */
  Collection<CampaignRow> rows() {
    return rows.values();
  }

  /** Keeps a result, at the latest half a second later in a file. */
  void add(CampaignRow row) {
    rows.put(row.id(), row);
    unsaved.add(row);
    if (System.nanoTime() - saved > PAUSE) {
      save();
    }
  }

  /** Writes the results that are in no file. */
  void save() {
    if (!unsaved.isEmpty()) {
      write(part(++parts), ResultJson.bytes(with(unsaved, false)));
      unsaved.clear();
    }
    saved = System.nanoTime();
  }

  private Cases with(Collection<CampaignRow> some, boolean complete) {
    return new Cases(
        empty.campaign(),
        empty.inputs(),
        empty.shard(),
        empty.combinations(),
        complete,
        List.copyOf(some));
  }

  /** Writes all cases into one file, after which nothing is missing. */
  void complete() {
    write(CASES, ResultJson.bytes(with(rows.values(), true)));
    output.removeAll(PARTS);
  }

  void write(String name, byte[] content) {
    output.write(name, content, OutputFolder.OnEdit.OVERWRITE);
  }

  @Override
  public void close() {
    output.close();
  }
}
