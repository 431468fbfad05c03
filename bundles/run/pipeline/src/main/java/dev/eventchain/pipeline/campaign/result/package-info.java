/** The results of a campaign: kept, merged, compared, summed up, and shown. */
package dev.eventchain.pipeline.campaign.result;
