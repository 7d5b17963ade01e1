#pragma once

namespace seahex
{

/// What of a vessel decides where it may go. All lengths in metres.
struct Vessel
{
    double draughtM = 1.2;             ///< from the waterline to the deepest part
    double underKeelClearanceM = 0.5;  ///< water that must remain under the keel
    double airDraughtM = 3.0;          ///< from the waterline to the highest part
    double beamM = 1.0;                ///< greatest width
    double marginM = 0.0;              ///< least horizontal distance to any hazard

    /// The depth below chart datum that the vessel needs: draught plus under-keel clearance.
    double requiredDepthM() const { return draughtM + underKeelClearanceM; }
};

}  // namespace seahex
