package dev.eventchain.pipeline.campaign.plan;

/** Purposes for which a campaign file is read. */
public enum Purpose {
  /** All its cases are simulated. */
  CAMPAIGN,
  /** A search goes between the bounds of what varies. */
  SEARCH
}
