package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.Outcome;

/**
 * The outcome of a campaign.
 *
 * @param outcome the findings, with the exit code
 * @param text what became of the cases, for people; empty if none was simulated
 */
public record CampaignOutcome(Outcome outcome, String text) {}
