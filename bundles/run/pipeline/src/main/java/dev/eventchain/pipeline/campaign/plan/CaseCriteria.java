package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import java.util.List;

/**
 * Criteria that a campaign file gives to cases, besides those of their scenario.
 *
 * @param accept what is required, as a scenario says it
 * @param conditions all true of the cases that have them; none if all cases have them
 * @param place where the file says so
 */
public record CaseCriteria(ObjectNode accept, List<SourceRange> conditions, SourceLocation place) {

  /** Copies what may be changed. */
  public CaseCriteria {
    accept = accept.deepCopy();
    conditions = List.copyOf(conditions);
  }

  /** Returns whether all cases have them. */
  public boolean areOfAll() {
    return conditions.isEmpty();
  }
}
