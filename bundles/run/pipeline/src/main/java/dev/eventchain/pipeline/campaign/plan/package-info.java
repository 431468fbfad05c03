/** Campaign files, and the cases that follow from them. */
package dev.eventchain.pipeline.campaign.plan;
