package dev.eventchain.pipeline.design;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.catalogue.SignalCatalogue;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.CatalogueSettings;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.retrieval.Shortlist;
import dev.eventchain.retrieval.Shortlist.Entry;
import dev.eventchain.retrieval.Shortlist.Text;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The signals of a catalogue that a design is offered: those that its requirements and the existing
 * components speak of. A whole catalogue in a prompt would be long, and chosen from worse.
 */
public final class OfferedSignals {

  /** The name of the list among the results of a run. */
  public static final String FILE = "retrieved.json";

  private final CatalogueSettings settings;
  private final Shortlist list;
  private final int all;

  private OfferedSignals(CatalogueSettings settings, Shortlist list, int all) {
    this.settings = settings;
    this.list = list;
    this.all = all;
  }

  /** Returns those of a project; empty if it names no catalogue. */
  static Optional<OfferedSignals> of(RunContext run) {
    SoftwareBase base = run.softwareBase();
    return run.project().catalogue().flatMap(it -> base.catalogue().map(of -> of(run, it, of)));
  }

  private static OfferedSignals of(
      RunContext run, CatalogueSettings settings, SignalCatalogue catalogue) {
    List<Text> texts = new ArrayList<>();
    for (WrittenRequirement item : run.requirements().items()) {
      texts.add(new Text(item.id(), item.text(), true));
    }
    for (SoftwareNode node : run.softwareBase().descriptions()) {
      texts.add(new Text(node.getName(), String.valueOf(node.getDescription()), false));
    }
    Shortlist list =
        Shortlist.of(
            catalogue, texts, settings.shortlist(), settings.pinned(), settings.excluded());
    return new OfferedSignals(settings, list, catalogue.signals().size());
  }

  /** Returns the software base with these signals of the catalogue only. */
  SoftwareBase in(SoftwareBase base) {
    return base.offering(list.signals());
  }

  /** Returns what was found, in words: ", offered 22 of 1367 signals". */
  String words() {
    return String.format(Locale.ROOT, ", offered %d of %d signals", list.signals().size(), all);
  }

  /** Writes the list, before anybody is asked, and reports if there is nothing to offer. */
  void report(RunContext run) {
    run.write(FILE, asJson());
    finding().ifPresent(run::find);
  }

  /** Returns the finding that there is nothing to offer. */
  private Optional<Diagnostic> finding() {
    return list.entries().isEmpty()
        ? Optional.of(
            Diagnostic.of(
                    DesignRules.NOTHING_RETRIEVED,
                    "No signal of the catalogue has a word of the requirements, so that the design was offered none.",
                    settings.place())
                .withHint("Pin the signals that it needs: `pinned: [...]` under `catalogue`."))
        : Optional.empty();
  }

  /** Returns the content of the file, best signals first. */
  private String asJson() {
    ArrayNode entries = JsonNodeFactory.instance.arrayNode();
    for (Entry entry : list.entries()) {
      ObjectNode json = entries.addObject();
      json.put("signals", entry.group().path());
      json.put("number", entry.group().signals().size());
      json.put("score", Math.round(entry.score() * 1000) / 1000.0);
      json.put("because", entry.because());
      json.put("pinned", entry.isPinned());
      json.put("meaning", entry.group().any().meaning());
    }
    return JsonLayout.of(entries);
  }
}
