package dev.eventchain.lsp.check;

import dev.eventchain.check.FileChecks;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Cancellation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.UnsavedTexts;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The checks of a workspace, one after the other in the background. A unit is checked again when a
 * file changes that it has read, on disk or in the editor, once nothing has been typed for a
 * moment; units with open files come first. A check ends early when its unit has to be checked
 * again anyway. Nothing is checked, looked for or shown under the lock, so that nobody waits for
 * that. Thread-safe.
 */
public final class Checks implements AutoCloseable {

  /**
   * Pause in typing after which something is checked: short enough for a file of 10,000 lines to
   * have its findings 300 ms after the last key.
   */
  public static final Duration QUIET = Duration.ofMillis(75);

  /** For the recursion of deep expressions, as on the command line. */
  private static final long STACK = 16L << 20;

  private final OpenTexts texts;
  private final Findings findings;
  private final Consumer<String> log;
  private final Thread thread = new Thread(null, this::work, "checks", STACK);

  private final Set<CheckUnit> waiting = new LinkedHashSet<>();

  /** The files that the last check of each unit has read. */
  private final Map<CheckUnit, Set<Path>> reads = new HashMap<>();

  /** The files that have changed since the present check began. */
  private final Set<Path> changedMeanwhile = new HashSet<>();

  /** The files and folders among them that are gone. */
  private final Set<Path> goneMeanwhile = new HashSet<>();

  private List<Path> folders = List.of();
  private Settings settings = Settings.USUAL;
  private WorkspaceFiles files = WorkspaceFiles.of(List.of(), List.of());
  private long reports;
  private boolean isListed = true;
  private boolean isBusy;
  private volatile boolean isClosed;

  /** The unit that is being checked; null if none is. */
  private CheckUnit present;

  /** The files that its check has read so far. */
  private volatile Set<Path> presentReads = Set.of();

  /** A copy of the files that have changed since it began: it reads texts as they were then. */
  private volatile Set<Path> changedSoFar = Set.of();

  /** True once the present check says nothing any more, since its unit waits for the next one. */
  private volatile boolean isSuperseded;

  /** The time of {@link System#nanoTime} until which somebody may still be typing. */
  private long quiet = System.nanoTime();

  /**
   * Creates checks of nothing.
   *
   * @param log takes what people may read about defects of the program
   */
  public Checks(OpenTexts texts, Findings findings, Consumer<String> log) {
    this.texts = texts;
    this.findings = findings;
    this.log = log;
    thread.setDaemon(true);
    thread.start();
  }

  /** Checks the files of these folders, and of no other ones but open files. */
  public synchronized void open(List<Path> newFolders, Settings newSettings) {
    folders = List.copyOf(newFolders);
    settings = newSettings;
    list();
  }

  /** Looks again for files, because one was opened or closed. */
  public synchronized void list() {
    isListed = false;
    notifyAll();
  }

  /** Checks what has read a file, after its text in the editor has changed. */
  public synchronized void changed(Path file) {
    quiet = System.nanoTime() + QUIET.toNanos();
    revisit(Set.of(file), Set.of());
  }

  /** Checks what has read files, after they have changed on disk. */
  public synchronized void changedOnDisk(Collection<Path> changed) {
    reports++;
    revisit(Set.copyOf(changed), Set.of());
  }

  /**
   * Checks what may read files now, or has read them, after they came or went on disk; of a folder
   * that is gone, what has read anything in it.
   */
  public void appearedOrGone(Collection<Path> changed) {
    List<Path> where = folders();
    List<Path> written =
        changed.stream().filter(file -> !WorkspaceFiles.isPassedOver(file, where)).toList();
    Set<Path> gone = changed.stream().filter(Files::notExists).collect(Collectors.toSet());
    synchronized (this) {
      reports++;
      revisit(Set.copyOf(changed), gone);
      for (CheckUnit unit : reads.keySet()) {
        // A project is checked wherever it is, such as one in a build tool's folder that is open.
        Collection<Path> seen = unit.project().isPresent() ? changed : written;
        if (seen.stream().anyMatch(file -> mayRead(unit, file))) {
          waiting.add(unit);
        }
      }
      if (!written.isEmpty()) {
        list();
      }
    }
  }

  private static boolean mayRead(CheckUnit unit, Path file) {
    return unit.project()
        .map(
            folder ->
                file.startsWith(folder) && !WorkspaceFiles.isPassedOver(file, List.of(folder)))
        .orElseGet(() -> WorkspaceFiles.isKnown(file));
  }

  private void revisit(Set<Path> changed, Set<Path> gone) {
    changedMeanwhile.addAll(changed);
    changedSoFar = Set.copyOf(changedMeanwhile);
    goneMeanwhile.addAll(gone);
    reads.forEach(
        (unit, read) -> {
          if (isAbout(unit, read, changed, gone)) {
            waiting.add(unit);
            isSuperseded |= unit.equals(present);
          }
        });
    notifyAll();
  }

  private static boolean isAbout(
      CheckUnit unit, Set<Path> read, Set<Path> changed, Set<Path> gone) {
    return changed.contains(unit.subject())
        || changed.stream().anyMatch(read::contains)
        || (!gone.isEmpty() && read.stream().anyMatch(file -> isBelow(file, gone)));
  }

  private static boolean isBelow(Path file, Set<Path> folders) {
    return Stream.iterate(file, Objects::nonNull, Path::getParent).anyMatch(folders::contains);
  }

  /** Returns the files of the workspace as they were last looked for. */
  public synchronized WorkspaceFiles files() {
    return files;
  }

  /** Returns how often changes on disk were reported: another number means that there were more. */
  public synchronized long reports() {
    return reports;
  }

  /** Returns the metamodels that a file may name. */
  public List<Path> metamodels(Path file) {
    return files().metamodels(file, settings().metamodelsIn(folders()));
  }

  /** Returns the files on which the findings depend. */
  public synchronized Set<Path> read() {
    Set<Path> all = new HashSet<>();
    reads.values().forEach(all::addAll);
    return all;
  }

  /** Waits until everything is checked. */
  public synchronized void await() throws InterruptedException {
    while (!isClosed && (isBusy || !isListed || !waiting.isEmpty())) {
      wait();
    }
  }

  private void work() {
    try {
      while (!isClosed()) {
        turn();
      }
    } catch (InterruptedException e) {
      close();
    }
  }

  /** Does what is next; a defect in it must not keep the rest from being checked. */
  private void turn() throws InterruptedException {
    try {
      if (needsList()) {
        look();
      } else {
        next().ifPresent(this::check);
      }
    } catch (RuntimeException | StackOverflowError e) {
      log.accept("eventchain: something was not checked, because the check itself failed: " + e);
    }
  }

  private synchronized boolean isClosed() {
    return isClosed;
  }

  private synchronized List<Path> folders() {
    return folders;
  }

  private synchronized Settings settings() {
    return settings;
  }

  /** Waits until there is something to do, and returns whether it is to look for files. */
  private synchronized boolean needsList() throws InterruptedException {
    isBusy = false;
    notifyAll();
    while (!isClosed && isListed && waiting.isEmpty()) {
      wait();
    }
    isBusy = true;
    boolean needed = !isListed;
    isListed = true;
    return needed;
  }

  private void look() {
    List<Path> where = folders();
    Settings with = settings();
    List<Path> open = texts.all().stream().map(OpenText::path).toList();
    WorkspaceFiles found = WorkspaceFiles.of(where, open);
    List<Path> named = with.metamodelsIn(where);
    List<CheckUnit> units =
        UnsavedTexts.during(texts.overlay(), () -> found.units(named, with.timeLimit()));
    list(found, units).forEach(findings::remove);
  }

  /** Takes over what was found, and returns the units that are gone. */
  private synchronized List<CheckUnit> list(WorkspaceFiles found, List<CheckUnit> units) {
    files = found;
    Set<CheckUnit> now = new LinkedHashSet<>(units);
    List<CheckUnit> gone = reads.keySet().stream().filter(each -> !now.contains(each)).toList();
    gone.forEach(reads::remove);
    waiting.retainAll(now);
    now.stream().filter(unit -> reads.putIfAbsent(unit, Set.of()) == null).forEach(waiting::add);
    return gone;
  }

  /**
   * Waits until nothing is typed, and returns the unit to be checked; empty if the list changes.
   */
  private synchronized Optional<CheckUnit> next() throws InterruptedException {
    long left = quiet - System.nanoTime();
    while (left > 0 && !isClosed) {
      wait(left / 1_000_000 + 1);
      left = quiet - System.nanoTime();
    }
    Set<Path> open = new HashSet<>();
    texts.all().forEach(text -> open.add(text.path()));
    Optional<CheckUnit> chosen =
        waiting.stream()
            .filter(unit -> open.contains(unit.subject()))
            .findFirst()
            .or(() -> waiting.stream().filter(unit -> readsAny(unit, open)).findFirst())
            .or(() -> waiting.stream().findFirst());
    if (!isListed) {
      return Optional.empty();
    }
    chosen.ifPresent(waiting::remove);
    present = chosen.orElse(null);
    presentReads = ConcurrentHashMap.newKeySet();
    isSuperseded = false;
    changedMeanwhile.clear();
    changedSoFar = Set.of();
    goneMeanwhile.clear();
    return chosen;
  }

  private boolean readsAny(CheckUnit unit, Set<Path> open) {
    Set<Path> read = reads.getOrDefault(unit, Set.of());
    Optional<Path> folder = unit.project().filter(each -> read.isEmpty());
    return open.stream()
        .anyMatch(file -> folder.map(file::startsWith).orElseGet(() -> read.contains(file)));
  }

  private void check(CheckUnit unit) {
    Set<Path> read = presentReads;
    Supplier<Validation> check =
        () -> FileChecks.attempt(unit.subject(), () -> new Validation(Coverage.NONE, unit.check()));
    Validation checked =
        Cancellation.during(
            this::isUnwanted,
            () -> UnsavedTexts.during(texts.overlay(), () -> FileReads.recordAll(read, check)));
    if (isPresent(unit, Set.copyOf(read))) {
      findings.replace(unit, checked.diagnostics());
    }
  }

  /** Returns whether the present check says nothing any more, which it has to find out itself. */
  private boolean isUnwanted() {
    Set<Path> changed = changedSoFar;
    return isSuperseded
        || isClosed
        || (!changed.isEmpty() && changed.stream().anyMatch(presentReads::contains));
  }

  /** Notes what the check of a unit has read, and returns whether none of it has changed since. */
  private synchronized boolean isPresent(CheckUnit unit, Set<Path> read) {
    present = null;
    if (isClosed || !reads.containsKey(unit)) {
      return false; // its file is gone meanwhile
    }
    reads.put(unit, read);
    if (isSuperseded || isAbout(unit, read, changedMeanwhile, goneMeanwhile)) {
      waiting.add(unit);
      return false;
    }
    return true;
  }

  /** Ends the checks; one that is being made ends early, and is not waited for. */
  @Override
  public synchronized void close() {
    isClosed = true;
    notifyAll();
  }
}
