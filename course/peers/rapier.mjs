// Rapier's KinematicCharacterController on the movement course, as its own guide sets it up: offset, slope angles,
// autostep and snap are the scene's; gravity is the caller's, as the guide says.
import RAPIER from '@dimforge/rapier3d-compat';
import { speak } from './protocol.mjs';

await RAPIER.init();

// `node rapier.mjs edges` has Rapier mend the inner edges of meshes, an option that is off by default.
const flags = process.argv[2] === 'edges' ? RAPIER.TriMeshFlags.FIX_INTERNAL_EDGES : undefined;

class Rapier {
    load({ settings, bodies, start }) {
        this.world?.free();
        this.settings = settings;
        this.world = new RAPIER.World({ x: 0, y: -settings.gravity, z: 0 });
        this.bodies = new Map();
        for (const { number, vertices, indices, pose, moves } of bodies) {
            const kind = moves ? RAPIER.RigidBodyDesc.kinematicPositionBased() : RAPIER.RigidBodyDesc.fixed();
            const description = kind
                .setTranslation(pose.position.x, pose.position.y, pose.position.z)
                .setRotation(pose.rotation);
            const body = this.world.createRigidBody(description);
            this.world.createCollider(
                RAPIER.ColliderDesc.trimesh(new Float32Array(vertices), new Uint32Array(indices), flags), body);
            this.bodies.set(number, body);
        }
        this.character = this.world.createRigidBody(
            RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(start.x, start.y, start.z));
        this.collider = this.world.createCollider(
            RAPIER.ColliderDesc.capsule(settings.half_height, settings.radius), this.character);
        const slope = (settings.slope_limit_deg * Math.PI) / 180;
        this.controller = this.world.createCharacterController(settings.skin);
        this.controller.setUp({ x: 0, y: 1, z: 0 });
        this.controller.setSlideEnabled(true);
        this.controller.setMaxSlopeClimbAngle(slope);
        this.controller.setMinSlopeSlideAngle(slope);
        this.controller.enableAutostep(settings.step_up, settings.step_depth, true);
        this.controller.enableSnapToGround(settings.snap_down);
        this.at = { ...start };
        this.vertical = 0;
        this.grounded = false;
        this.jump_held = false;
    }

    tick({ dt, wish, jump, poses }) {
        const { gravity, jump_height, terminal_speed } = this.settings;
        for (const [number, pose] of poses) {
            this.bodies.get(number).setNextKinematicTranslation(pose.position);
            this.bodies.get(number).setNextKinematicRotation(pose.rotation);
        }
        this.world.timestep = dt;
        this.world.step();
        if (jump && !this.jump_held && this.grounded) this.vertical = Math.sqrt(2 * gravity * jump_height);
        this.jump_held = jump;
        this.vertical = Math.max(this.vertical - gravity * dt, -terminal_speed);
        this.controller.computeColliderMovement(
            this.collider, { x: wish.x * dt, y: this.vertical * dt, z: wish.z * dt });
        const moved = this.controller.computedMovement();
        this.grounded = this.controller.computedGrounded();
        // What stopped it on its way up or down stops its speed too.
        if (this.grounded && this.vertical < 0) this.vertical = 0;
        if (this.vertical > 0 && moved.y < 0.5 * this.vertical * dt) this.vertical = 0;
        this.at = { x: this.at.x + moved.x, y: this.at.y + moved.y, z: this.at.z + moved.z };
        this.character.setTranslation(this.at, true);
        return { ...this.at, grounded: this.grounded };
    }
}

await speak(new Rapier());
