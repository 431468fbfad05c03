package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The criteria of a campaign file: those of one campaign, and those of all campaigns that have some
 * tags.
 */
final class CriteriaByTags {

  static final String KEY = "criteria";

  private static final String TAGS = "tags";
  private static final String TAG = "[A-Za-z0-9_][A-Za-z0-9_.:/-]*";

  private final List<Tagged> tagged = new ArrayList<>();
  private final Set<String> known = new TreeSet<>();
  private final List<Set<String>> all = new ArrayList<>();

  /** Criteria of the campaigns that have all of some tags. */
  private record Tagged(Set<String> tags, CaseCriteria criteria, SourceLocation place) {}

  /** Reads the criteria of a file of several campaigns. */
  void ofFile(ObjectReader document) {
    for (ObjectReader entry : document.objects(KEY)) {
      Set<String> tags = tags(entry);
      if (!entry.has(TAGS)) {
        entry.find(CampaignRules.KEY_MISSING, "'tags' is missing.", entry.location());
      } else if (entry.texts(TAGS).isEmpty()) {
        entry.find(CampaignRules.VALUE_RANGE, "No tag is named.", entry.at(TAGS));
      }
      criteria(entry).ifPresent(it -> tagged.add(new Tagged(tags, it, entry.at(TAGS))));
    }
  }

  /** Reads the tags and the criteria of a campaign; returns all criteria that its cases have. */
  List<CaseCriteria> of(ObjectReader campaign) {
    Set<String> tags = tags(campaign);
    known.addAll(tags);
    all.add(tags);
    List<CaseCriteria> criteria = new ArrayList<>();
    tagged.stream()
        .filter(each -> tags.containsAll(each.tags()))
        .forEach(each -> criteria.add(each.criteria()));
    for (ObjectReader entry : campaign.objects(KEY)) {
      criteria(entry).ifPresent(criteria::add);
    }
    return criteria;
  }

  /** Reports the criteria whose tags no campaign has, once all campaigns are read. */
  void refuseIdle(ObjectReader document) {
    for (Tagged each : tagged) {
      if (!each.tags().isEmpty() && all.stream().noneMatch(own -> own.containsAll(each.tags()))) {
        document.find(idle(each));
      }
    }
  }

  private Diagnostic idle(Tagged criteria) {
    Optional<String> unknown =
        criteria.tags().stream().filter(tag -> !known.contains(tag)).findFirst();
    Diagnostic finding =
        Diagnostic.of(
            CampaignRules.TAG,
            unknown
                .map(tag -> "No campaign has the tag '" + tag + "'.")
                .orElse("No campaign has all of the tags " + words(criteria.tags()) + "."),
            criteria.place());
    return unknown
        .map(tag -> finding.withHint(NearestName.hint(tag, known)))
        .orElseGet(() -> finding.withHint("A case needs all of them: write an entry for each."));
  }

  private static String words(Collection<String> tags) {
    return "'" + String.join("', '", tags) + "'";
  }

  private static Set<String> tags(ObjectReader section) {
    Set<String> tags = new LinkedHashSet<>();
    for (String tag : section.texts(TAGS)) {
      if (!tag.matches(TAG)) {
        String message = "A tag has letters, digits, '_', '-', '.', ':' and '/', and no spaces.";
        section.find(CampaignRules.VALUE_RANGE, message, section.at(TAGS));
      } else if (!tags.add(tag)) {
        section.find(CampaignRules.VALUE_RANGE, "'" + tag + "' is here twice.", section.at(TAGS));
      }
    }
    return tags;
  }

  private static Optional<CaseCriteria> criteria(ObjectReader entry) {
    entry.text("description"); // for people
    Optional<JsonNode> accept =
        entry
            .requiredObject("accept")
            .flatMap(it -> entry.value("accept"))
            .filter(node -> isAny(entry, node));
    List<SourceRange> where = CampaignReader.conditions(entry);
    entry.refuseOthers();
    return accept.map(it -> new CaseCriteria((ObjectNode) it, where, entry.location()));
  }

  private static boolean isAny(ObjectReader entry, JsonNode accept) {
    if (accept.isEmpty()) {
      entry.find(CampaignRules.EMPTY, "Nothing is required here.", entry.at("accept"));
    }
    return !accept.isEmpty();
  }
}
